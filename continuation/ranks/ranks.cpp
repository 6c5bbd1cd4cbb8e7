#include "continuation/ranks/ranks.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "framework/base/errors.hpp"
#include "framework/base/launched.hpp"
#include "framework/base/loaded.hpp"

namespace dda {
namespace {

/// MPI, loaded by runs of several ranks alone.
Transport& transport() {
  using Maker = Transport* (*)();
  static const auto maker = reinterpret_cast<Maker>(symbol_of(module_file("dda_ranks.so"), "dda_ranks"));
  Transport& out = *maker();
  const Launched asked = launched();
  if (out.size() != static_cast<std::size_t>(asked.size))
    throw InputError(
        {}, fmt::format("dda was started as {} processes by a launcher that its MPI does not know; start "
                        "them by Open MPI's mpirun, or by `srun --mpi=pmix`",
                        asked.size));
  return out;
}

std::string machine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::vector<std::byte> bytes_of(const std::string& text) {
  Message out;
  out.put_all<char>(text);
  return out.bytes();
}

std::string text_of(std::vector<std::byte> bytes) {
  const std::vector<char> out = Message(std::move(bytes)).take_all<char>();
  return {out.begin(), out.end()};
}

Ranks* of_run = nullptr;

}  // namespace

Ranks* ranks_of_run() { return of_run; }
void set_ranks_of_run(Ranks* ranks) { of_run = ranks; }

Ranks Ranks::here(std::vector<Answer> answers) {
  Ranks out;
  out.answers_ = std::move(answers);
  out.machines_.assign(out.answers_.size(), machine());
  for (std::size_t k = 0; k < out.answers_.size(); ++k) out.beside_.push_back(k);
  return out;
}

Ranks Ranks::of_launcher(Answer answer) {
  Ranks out = here({std::move(answer)});
  out.transport_ = &transport();
  for (std::size_t k = 1; k < out.transport_->size(); ++k) {
    out.machines_.push_back(text_of(out.transport_->receive(k)));
    if (out.machines_.back() == out.machines_.front()) out.beside_.push_back(k);
  }
  return out;
}

/// What others reply begins with whether they could.
Message Ranks::reply_of(std::size_t rank, Message& request) {
  if (rank < answers_.size()) return answers_[rank](request);
  Message reply(transport_->receive(rank));
  traffic_.received += reply.bytes().size();
  if (reply.take<bool>()) return reply;
  const std::vector<char> words = reply.take_all<char>();
  throw std::runtime_error(
      fmt::format("rank {} on {}: {}", rank, machines_[rank], std::string(words.begin(), words.end())));
}

void Ranks::exchange(const std::function<std::optional<Message>(std::size_t)>& request,
                     const std::function<void(std::size_t, Message&)>& take) {
  std::vector<std::optional<Message>> own(size());
  std::vector<bool> is_asked(size(), false);
  ++traffic_.exchanges;
  std::exception_ptr failure;
  const auto attempt = [&](const auto& what) {
    try {
      what();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  };
  for (std::size_t rank = size(); rank-- > 0;)  // the others first, so that they are at work beside rank 0
    attempt([&] {
      auto message = request(rank);
      if (!message) return;
      if (rank < answers_.size()) {
        own[rank] = std::move(message);
      } else {
        transport_->send(rank, message->bytes());
        traffic_.sent += message->bytes().size();
      }
      is_asked[rank] = true;
    });
  for (std::size_t rank = 0; rank < size(); ++rank)
    if (is_asked[rank])
      attempt([&] {
        Message nothing;
        Message reply = reply_of(rank, own[rank] ? *own[rank] : nothing);
        own[rank].reset();
        take(rank, reply);
      });
  if (failure) std::rethrow_exception(failure);
}

void Ranks::end() {
  for (std::size_t rank = answers_.size(); rank < size(); ++rank) transport_->send(rank, {});
}

/// A rank ends with the daemon of the launcher that has started it, however that ends.
void serve_ranks(const Answer& answer) {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2, SIGXFSZ}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  Transport& to = transport();
  to.send(0, bytes_of(machine()));
  for (std::vector<std::byte> bytes; !(bytes = to.receive(0)).empty();) {
    Message request(std::move(bytes)), reply;
    const auto fail = [&reply](const std::string& words) {
      reply = {};
      reply.put(false);
      reply.put_all<char>(words);
    };
    try {
      const Message content = answer(request);
      reply.put(true);
      reply.append(content);
    } catch (const std::bad_alloc&) {
      fail("not enough memory");
    } catch (const std::exception& error) {
      fail(error.what());
    }
    to.send(0, reply.bytes());
  }
}

}  // namespace dda
