#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "meshing/files/geo_scan.hpp"
#include "meshing/files/geo_tokens.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

/// Files in a folder of their own, removed at the end.
class GeoScan : public ::testing::Test {
 protected:
  GeoScan()
      : folder_(std::filesystem::temp_directory_path() /
                ("dda_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::create_directories(folder_);
  }
  ~GeoScan() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// What is refused, one finding per line, without the folder.
  std::string refused(const std::string& text) const {
    Findings findings;
    refuse_commands(write("it.geo", text), {folder_}, findings);
    try {
      findings.throw_if_any();
    } catch (const InputError& error) {
      std::string out = error.what();
      const std::string prefix = folder_.string() + "/";
      for (auto at = out.find(prefix); at != std::string::npos; at = out.find(prefix))
        out.erase(at, prefix.size());
      return out;
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(GeoScan, LetsGeometryPass) {
  EXPECT_EQ(refused(R"(SetFactory("OpenCASCADE"); // SystemCall "rm";
/* Exit; */ DefineConstant[h = {0.3, Name "Save"}]; Print.Background = 1;
Macro corner
  Point(1) = {0, 0, 0, 1e-3}; Printf("%g > 3", h);
Return
Call corner; If(h > 2) Point(2) = {1.5e3, .5, 0}; EndIf
s = 'Merge "x"'; Field[1] = MathEval; Field[1].F = "Exit";)"),
            "");
}

TEST_F(GeoScan, RefusesWhatReachesBeyondTheGeometryWithItsPlace) {
  EXPECT_THAT(refused("a = 1;\n  SystemCall \"rm -r x\";"),
              HasSubstr("it.geo:2:3: 'SystemCall' runs a program"));
  for (const char* const text : {"System \"x\";",
                                 "NonBlockingSystemCall \"x\";",
                                 "OnelabRun (\"x\");",
                                 "Save \"x.msh\";",
                                 "Print \"x.pos\";",
                                 "Printf(\"%g\", 1) > \"x\";",
                                 "Printf(\"a\") >> \"x\";",
                                 "Printf(Sprintf(\"(\")) > \"x\";",
                                 "Exit;",
                                 "Abort;",
                                 "CreateDir \"x\";",
                                 "Plugin(Cut).Run;",
                                 "Sleep 10;",
                                 "Field[1] = ExternalProcess;",
                                 "General.LogFileName = \"x\";",
                                 "Macro(\"a\") \"Exit;\"",
                                 "1Exit;",
                                 "1.5e3Exit;",
                                 "/**/Exit;",
                                 "s = 'a\"'; Exit;",
                                 "//\nExit;",
                                 "Merge Str(\"a\");",
                                 "f = \"x\"; Include f;"})
    EXPECT_THAT(refused(text), HasSubstr("`--trust-geo`")) << text;
}

TEST_F(GeoScan, FollowsFilesInsideTheFolderAndRefusesOthers) {
  write("parts.geo", "x = 1;\nExit;");
  EXPECT_THAT(refused("Include \"parts.geo\";"), HasSubstr("parts.geo:2:1: 'Exit'"));
  write("parts.geo", "Merge \"it.geo\"; Merge \"mesh.msh\";");
  write("mesh.msh", "$MeshFormat 4.1 1 8 Exit");
  EXPECT_EQ(refused("Merge \"parts.geo\";"), "");
  EXPECT_THAT(refused("Merge \"/etc/passwd\";"), HasSubstr("lies outside the folder"));
  EXPECT_THAT(refused("Merge \"../x.geo\";"), HasSubstr("it.geo:1:7: '../x.geo' lies outside the folder"));
  std::filesystem::create_symlink("/etc", folder_ / "link");
  EXPECT_THAT(refused("Merge \"link/passwd\";"), HasSubstr("lies outside the folder"));
  EXPECT_THAT(refused("a() = ListFromFile[\"/etc/passwd\"];"), HasSubstr("lies outside the folder"));
}

TEST_F(GeoScan, RefusesWhatGmshCutsOtherwise) {
  EXPECT_THAT(refused("x = \"" + std::string(1024, 'a') + "\";"), HasSubstr("which gmsh cuts"));
  EXPECT_EQ(refused("x = \"" + std::string(1023, 'a') + "\";"), "");
  EXPECT_THAT(refused(std::string("x = 1;\0Exit;", 12)), HasSubstr("zero bytes"));
}

}  // namespace
}  // namespace dda
