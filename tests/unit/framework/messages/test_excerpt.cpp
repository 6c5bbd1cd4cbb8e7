#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "framework/messages/colour.hpp"
#include "framework/messages/excerpt.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

class Excerpt : public testing::Test {
 protected:
  std::string file(const std::string& text) const {
    const std::string name = (scratch_.path() / "deck.yaml").string();
    std::ofstream(name) << text;
    return name;
  }
  test::Scratch scratch_;
};

TEST_F(Excerpt, PointsAtTheWord) {
  const std::string name = file("law:\n  strengh: 3\n");
  EXPECT_EQ(excerpt({name, 2, 3}), "      2 |   strengh: 3\n        |   ^~~~~~~");
  EXPECT_EQ(excerpt({name, 2, 10}), "      2 |   strengh: 3\n        |          ^");
  EXPECT_EQ(excerpt({name, 2, 13}), "      2 |   strengh: 3\n        |             ^");
}

TEST_F(Excerpt, CountsCharacters) {
  EXPECT_EQ(excerpt({file("größe: über\n"), 1, 8}), "      1 | größe: über\n        |        ^~~~");
  EXPECT_EQ(excerpt({file("\ta: b\r\n"), 1, 2}), "      1 |  a: b\n        |  ^");
}

TEST_F(Excerpt, ShowsThePartOfALongLine) {
  const std::string text = excerpt({file(std::string(300, 'x') + " y: 1 " + std::string(300, 'z')), 1, 302});
  EXPECT_LT(text.size(), 250u);
  EXPECT_THAT(text, HasSubstr(" y: 1 "));
  const std::size_t line = text.find('\n');
  EXPECT_EQ(text.find('y'), text.find('^') - line - 1);
}

TEST_F(Excerpt, OfWhatIsNotThereIsNone) {
  const std::string name = file("a: 1\n");
  for (const Position& where : {Position{name, 0, 0}, Position{name, 2, 1}, Position{name, 1, 9},
                                Position{name, -1, 1}, Position{"no such file", 1, 1},
                                Position{"/dev/zero", 1, 1}, Position{scratch_.path().string(), 1, 1}})
    EXPECT_EQ(excerpt(where), "") << to_string(where);
}

TEST_F(Excerpt, FollowsEachFinding) {
  const std::string name = file("a: 1\nb: 2\n");
  Findings findings;
  findings.add({"--set x", 0, 0}, "neither");
  findings.add({name, 1, 1}, "no");
  findings.add({name, 2, 4}, "nor");
  std::string said;
  try {
    findings.throw_if_any();
  } catch (const InputError& error) {
    said = with_excerpts(error);
  }
  EXPECT_EQ(said, "--set x: neither\n" + name + ":1:1: no\n      1 | a: 1\n        | ^\n" + name +
                      ":2:4: nor\n      2 | b: 2\n        |    ^");
}

TEST_F(Excerpt, HasColoursForTerminals) {
  const std::string name = file("a: 1\n");
  const std::vector<Finding> findings{{{name, 1, 1}, "no"}, {{}, "nowhere"}};
  EXPECT_EQ(with_excerpts(InputError(findings), true),
            "\x1b[1m" + name +
                ":1:1\x1b[0m: \x1b[31merror:\x1b[0m no\n      1 | a: 1\n        | \x1b[31m^\x1b[0m\n" +
                "\x1b[31merror:\x1b[0m nowhere");
  std::FILE* no_terminal = std::tmpfile();
  EXPECT_FALSE(shows_colours(no_terminal));
  EXPECT_EQ(coloured_end("done", 0, no_terminal), "done");
  std::fclose(no_terminal);
}

TEST_F(Excerpt, SaysHowManyMore) {
  std::vector<Finding> findings(35, {{"", 0, 0}, "wrong"});
  EXPECT_THAT(with_excerpts(InputError(findings)), testing::EndsWith("\n... and 5 more"));
}

}  // namespace
}  // namespace dda
