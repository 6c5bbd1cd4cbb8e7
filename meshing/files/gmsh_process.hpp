#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/files/gmsh_model.hpp"

namespace dda {

/// What a process of gmsh is started with.
struct GmshTask {
  std::function<std::shared_ptr<const GmshModel>(const GmshModule&)> open;
  std::string subject;                         ///< for messages: "'beam.geo'"
  Position where;                              ///< for what is wrong without a place of its own
  std::vector<std::filesystem::path> folders;  ///< in which gmsh may read
  bool is_confined = true;  ///< it may do nothing else; needs Linux with seccomp or Landlock
  double seconds = 0;       ///< longest time for one answer [s]
};

/// The GmshModel of a process of its own, which ends with it.
///
/// A geometry is a program in gmsh's language, and gmsh ends or breaks the process it runs in for some input.
/// Here a forked process loads gmsh, gives up what rights it does not need, and answers `layout` and `mesh`;
/// what it says is the same to the last bit. Whatever ends it early is an InputError; so is an answer that
/// takes longer than allowed.
class GmshProcess final : public GmshModel {
 public:
  /// Forks and opens. Throws InputError with what gmsh says, std::runtime_error when gmsh cannot be loaded.
  explicit GmshProcess(GmshTask task);
  ~GmshProcess() override;

  Layout layout() const override;
  Cells mesh(const ElementWish& wish) const override;

 private:
  void start();
  std::string answer() const;
  std::string ask(std::string_view request) const;
  [[noreturn]] void fail_ended() const;

  GmshTask task_;
  mutable pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace dda
