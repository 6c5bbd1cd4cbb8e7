#include <mpi.h>
#include <time.h>

#include <algorithm>
#include <stdexcept>

#include "continuation/modules/mpi_start.hpp"
#include "continuation/ranks/transport.hpp"

namespace dda {
namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 30;  // MPI counts by int

/// Point to point in the world of the launcher.
class MpiTransport final : public Transport {
 public:
  std::size_t size() const override { return number(MPI_Comm_size); }
  std::size_t rank() const override { return number(MPI_Comm_rank); }

  void send(std::size_t to, const std::vector<std::byte>& bytes) override {
    std::size_t count = bytes.size();
    MPI_Send(&count, sizeof count, MPI_BYTE, static_cast<int>(to), tag, MPI_COMM_WORLD);
    for (std::size_t at = 0; at < count; at += most_at_once)
      MPI_Send(bytes.data() + at, part(count - at), MPI_BYTE, static_cast<int>(to), tag, MPI_COMM_WORLD);
  }

  std::vector<std::byte> receive(std::size_t from) override {
    std::size_t count = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(&count, sizeof count, MPI_BYTE, static_cast<int>(from), tag, MPI_COMM_WORLD, &request);
    wait(request);
    std::vector<std::byte> out(count);
    for (std::size_t at = 0; at < count; at += most_at_once)
      MPI_Recv(out.data() + at, part(count - at), MPI_BYTE, static_cast<int>(from), tag, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
    return out;
  }

 private:
  static constexpr int tag = 1;

  template <class Ask>
  static std::size_t number(Ask ask) {
    int out = 0;
    ask(MPI_COMM_WORLD, &out);
    return static_cast<std::size_t>(out);
  }
  static int part(std::size_t count) { return static_cast<int>(std::min(count, most_at_once)); }

  /// MPI's own wait would keep a processor busy that other ranks, or their threads, have use for.
  static void wait(MPI_Request& request) {
    constexpr int looks_in_a_row = 2000;
    const timespec pause{0, 50'000};
    int has_come = 0;
    for (int look = 0; MPI_Test(&request, &has_come, MPI_STATUS_IGNORE), has_come == 0; ++look)
      if (look > looks_in_a_row) nanosleep(&pause, nullptr);
  }
};

}  // namespace
}  // namespace dda

/// What continuation/ranks/ranks.cpp loads.
extern "C" dda::Transport* dda_ranks() {
  dda::start_mpi();
  static dda::MpiTransport transport;
  return &transport;
}
