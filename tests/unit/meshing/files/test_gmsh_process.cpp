#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "meshing/files/exchange.hpp"
#include "meshing/files/gmsh_process.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

/// What a process that opens its model with `work` ends in.
std::string end_of(const std::function<void()>& work, double seconds = 20) {
  GmshTask task{
      .open = [&](const GmshModule&) -> std::shared_ptr<const GmshModel> { return work(), nullptr; },
      .subject = "'it.geo'",
      .where = {"deck.yaml", 3, 4},
      .folders = {},
      .is_confined = true,
      .seconds = seconds};
  try {
    const GmshProcess process(std::move(task));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GmshProcess, TurnsEveryEndIntoAnErrorWithItsPlace) {
  EXPECT_THAT(end_of([] { std::signal(SIGSEGV, SIG_DFL), std::raise(SIGSEGV); }),
              HasSubstr("deck.yaml:3:4: gmsh crashed (Segmentation fault)"));
  EXPECT_THAT(end_of([] { std::abort(); }), HasSubstr("crashed (Aborted) with 'it.geo'"));
  EXPECT_THAT(end_of([] { std::exit(0); }), HasSubstr("ended itself"));
  EXPECT_THAT(end_of([] { throw std::string("no such surface"); }), HasSubstr("'it.geo': no such surface"));
  EXPECT_THAT(end_of([] { throw std::bad_alloc(); }), HasSubstr("not enough memory"));
  EXPECT_THAT(end_of([] { throw InputError({"it.geo", 1, 2}, "wrong"); }), HasSubstr("it.geo:1:2: wrong"));
  EXPECT_THAT(end_of(
                  [] {
                    for (;;) pause();
                  },
                  0.2),
              HasSubstr("stopped after 0.2 s"));
}

/// seccomp and Landlock are the kernel's: where it has neither, files can be written.
TEST(GmshProcess, HasNoRightsBeyondItsFolder) {
  const auto file = std::filesystem::temp_directory_path() / "dda_confined";
  std::filesystem::remove(file);
  const auto here = getppid();
  const std::string said = end_of([&] {
    std::string done;
    const auto note = [&](bool is_done, const char* what) { done += is_done ? std::string(what) + " " : ""; };
    note(open(file.c_str(), O_WRONLY | O_CREAT, 0600) >= 0, "wrote");
    note(open("/etc/passwd", O_RDONLY) >= 0, "read");
    note(socket(AF_INET, SOCK_STREAM, 0) >= 0, "connected");
    note(fork() >= 0, "forked");
    note(kill(here, 0) == 0, "signalled");
    note(std::system("true") == 0, "ran");
    throw std::string("done: " + done + ".");
  });
  if (said.find("wrote") != std::string::npos) GTEST_SKIP() << "this kernel confines nothing: " << said;
  EXPECT_THAT(said, HasSubstr("done: .")) << "what it could do";
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Exchange, GivesBackTheSameBits) {
  Layout layout;
  layout.regions = {{"left", "concrete"}, {"right", "steel"}};
  layout.shapes = {{{Polygon{{{0, 0}, {1.0 / 3, 0}, {0, 1}}}, {Polygon{{{0.1, 0.1}}}}}, 1, {"a.yaml", 1, 2}}};
  layout.lines = {{LineRole::slit, "notch", {{0, 1e-300}, {-0.0, 2}}, {"b.yaml", 3, 4}, true}};
  layout.points = {{"tip", {0.1, 0.2}}};
  layout.where = {"deck.yaml", 5, 6};
  const std::string bytes = packed(layout);
  EXPECT_EQ(packed(unpacked<Layout>(bytes)), bytes);
  const ElementWish wish{2, true, Refinement{"crack", 0.1, 0.3}};
  EXPECT_EQ(unpacked<ElementWish>(packed(wish)).refine->growth, 0.3);
  EXPECT_THROW(unpacked<Layout>(std::string_view(bytes).substr(1)), std::runtime_error);
  EXPECT_THROW(unpacked<Layout>(bytes + "x"), std::runtime_error);
}

}  // namespace
}  // namespace dda
