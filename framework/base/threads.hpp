#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace dda {

/// Threads that loops are shared among, the calling one included: what set_num_threads said last, else
/// OMP_NUM_THREADS, else the processors that this process may use (affinity, and a container's share).
int num_threads();
/// Counts for the loops that follow. Throws std::invalid_argument below 1.
void set_num_threads(int count);

namespace threads {

/// What one thread does of a loop: indices from `begin` to before `end`.
using Piece = void (*)(void* loop, std::size_t begin, std::size_t end);

void share_out(std::size_t count, std::size_t grain, Piece piece, void* loop);

}  // namespace threads

/// body(begin, end) for the pieces [0, grain), [grain, 2 grain), … of [0, count), each by one of the threads.
///
/// The pieces are the same for any number of threads, and each is done once; so a result that is put together
/// in their order repeats bit for bit. One piece, or a loop inside another one, is done by the calling thread
/// alone. What a body throws reaches the caller: of several exceptions that of the first piece. Bodies must
/// not write what another one reads, nor use Timings, a log or any file.
template <class Body>
void parallel_pieces(std::size_t count, std::size_t grain, Body&& body) {
  using Plain = std::remove_reference_t<Body>;
  threads::share_out(
      count, grain,
      [](void* loop, std::size_t begin, std::size_t end) { (*static_cast<Plain*>(loop))(begin, end); },
      const_cast<std::remove_const_t<Plain>*>(std::addressof(body)));
}

/// body(i) for each i in [0, count); about `grain` of them are worth waking another thread for.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, Body&& body) {
  parallel_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Σ term(i) over [0, count): each piece of `grain` terms in order, then the pieces in order.
template <class Term>
double parallel_sum(std::size_t count, std::size_t grain, Term&& term) {
  std::vector<double> sums((count + grain - 1) / grain, 0.0);
  parallel_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    sums[begin / grain] = sum;
  });
  double out = 0;
  for (const double sum : sums) out += sum;
  return out;
}

}  // namespace dda
