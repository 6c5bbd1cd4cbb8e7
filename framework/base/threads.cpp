#include "framework/base/threads.hpp"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "framework/base/launched.hpp"

namespace dda {
namespace {

/// A loop that is being worked on.
class Loop {
 public:
  Loop(std::size_t count, std::size_t grain, threads::Piece piece, void* body)
      : count_(count), grain_(grain), piece_(piece), body_(body) {}

  /// Takes pieces until none is left. Pieces are taken in order, so that all those before one that throws are
  /// done.
  void work() {
    while (!has_failed_.load(std::memory_order_relaxed)) {
      const std::size_t begin = next_.fetch_add(grain_, std::memory_order_relaxed);
      if (begin >= count_) return;
      try {
        piece_(body_, begin, std::min(begin + grain_, count_));
      } catch (...) {
        keep(std::current_exception(), begin);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void keep(std::exception_ptr error, std::size_t begin) {
    const std::lock_guard lock(mutex_);
    has_failed_ = true;
    if (begin >= failed_at_) return;
    failed_at_ = begin;
    error_ = std::move(error);
  }

  const std::size_t count_, grain_;
  const threads::Piece piece_;
  void* const body_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  std::size_t failed_at_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr error_;
};

/// Threads that sleep until there is a loop to share. OpenMP's spin between loops and at the end of each,
/// which takes the processor from the serial phases of other processes; and its caller waits for threads that
/// the system has not even started yet.
class Pool {
 public:
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// With `helpers` other threads.
  void run(Loop& loop, std::size_t helpers) {
    while (threads_.size() < helpers) add_thread();
    {
      const std::lock_guard lock(mutex_);
      loop_ = &loop;
      welcome_ = helpers;
    }
    if (helpers == 1 && threads_.size() == 1)
      wake_.notify_one();
    else
      wake_.notify_all();
    loop.work();
    std::unique_lock lock(mutex_);
    welcome_ = 0;
    loop_ = nullptr;
    done_.wait(lock, [&] { return inside_ == 0; });
  }

 private:
  /// Signals are the main thread's.
  void add_thread() {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    threads_.emplace_back([this] { serve(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      wake_.wait(lock, [&] { return is_over_ || welcome_ > 0; });
      if (is_over_) return;
      Loop* const loop = loop_;
      --welcome_;
      ++inside_;
      lock.unlock();
      loop->work();
      lock.lock();
      if (--inside_ == 0) done_.notify_one();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::vector<std::thread> threads_;
  Loop* loop_ = nullptr;
  std::size_t welcome_ = 0, inside_ = 0;  ///< threads that may still join the loop, and that are at it
  bool is_over_ = false;
};

/// The processors' time that a container may use, rounded up; nothing set: none.
int container_share() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  double quota = 0, period = 0;
  if (!(file >> quota >> period) || period <= 0) return std::numeric_limits<int>::max();
  return std::max(1, static_cast<int>(std::ceil(quota / period)));
}

/// Ranks of one run that are not bound to processors of their own share those of their machine.
int usable_processors() {
  const int all = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  cpu_set_t set;
  CPU_ZERO(&set);
  const int allowed = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : all;
  const int usable = std::min(allowed, container_share());
  return std::max(1, allowed < all ? usable : usable / launched().size_here);
}

/// OMP_NUM_THREADS may be a list, by level of nesting.
int default_threads() {
  const char* const text = std::getenv("OMP_NUM_THREADS");
  const int wanted = text ? std::atoi(text) : 0;
  return wanted > 0 ? wanted : usable_processors();
}

int& thread_count() {
  static int count = default_threads();
  return count;
}

std::atomic<bool> is_sharing{false};

}  // namespace

int num_threads() { return thread_count(); }

void set_num_threads(int count) {
  if (count < 1) throw std::invalid_argument("there is no computing with less than one thread");
  thread_count() = count;
}

void threads::share_out(std::size_t count, std::size_t grain, Piece piece, void* body) {
  if (count == 0) return;
  Loop loop(count, grain, piece, body);
  const std::size_t pieces = (count - 1) / grain + 1;
  const std::size_t helpers = std::min(static_cast<std::size_t>(num_threads()), pieces) - 1;
  if (helpers == 0 || is_sharing.exchange(true)) {
    loop.work();
  } else {
    static Pool pool;
    pool.run(loop, helpers);
    is_sharing = false;
  }
  loop.rethrow();
}

}  // namespace dda
