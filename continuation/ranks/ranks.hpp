#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continuation/ranks/message.hpp"
#include "continuation/ranks/transport.hpp"

namespace dda {

/// What a rank does when it is asked: the reply to a request.
using Answer = std::function<Message(Message& request)>;

/// What has gone between rank 0 and the others.
struct Traffic {
  std::size_t exchanges = 0;           ///< of all ranks at once
  std::size_t sent = 0, received = 0;  ///< bytes, by rank 0
};

/// The processes of one run. Rank 0 follows the path, alone: it decides, reads and writes. What others do, and what it
/// does itself beside them, it asks for by requests, and takes the replies in the order of the ranks, so that sums
/// are the same bits each time.
class Ranks {
 public:
  /// Those that the launcher has started; called by rank 0, whose own answers are these. Throws InputError where
  /// MPI does not know of them.
  static Ranks of_launcher(Answer answer);
  /// All of them in this process, one after another.
  static Ranks here(std::vector<Answer> answers);

  std::size_t size() const { return answers_.size() + (transport_ ? transport_->size() - 1 : 0); }
  /// Ranks on this machine with rank 0, itself among them.
  const std::vector<std::size_t>& beside() const { return beside_; }

  const Traffic& traffic() const { return traffic_; }

  /// Sends every rank its request, if there is one, and hands over the replies. Where ranks fail all are waited for;
  /// throws what rank 0 threw, or std::runtime_error with the rank, its machine and its words.
  void exchange(const std::function<std::optional<Message>(std::size_t rank)>& request,
                const std::function<void(std::size_t rank, Message& reply)>& take);
  /// Lets the others end. Nothing is asked after it.
  void end();

 private:
  Message reply_of(std::size_t rank, Message& request);

  std::vector<Answer> answers_;  ///< of rank 0, and others that are in this process
  Transport* transport_ = nullptr;
  std::vector<std::string> machines_;
  std::vector<std::size_t> beside_;
  Traffic traffic_;
};

/// Answers rank 0 until it ends; what another rank does. Signals are left to rank 0.
void serve_ranks(const Answer& answer);

/// The ranks of this run; null where it has one. Set once, before anything is computed.
Ranks* ranks_of_run();
void set_ranks_of_run(Ranks* ranks);

}  // namespace dda
