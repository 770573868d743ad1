#include "tui/screen/key.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tui/app/colon_command.hpp"
#include "tui/app/key_script.hpp"

namespace tapfit::tui {
namespace {

TEST(Key, ReadsWhatItNames) {
  for (const Key key : {Key(U'a'),
                        Key(U'<'),
                        Key(U' '),
                        Key(keys::enter),
                        Key(keys::back_tab),
                        Key(U'r', true)}) {
    const std::optional<NamedKey> read = read_key(name(key));
    ASSERT_TRUE(read.has_value()) << name(key);
    EXPECT_EQ(read->key, key) << name(key);
    EXPECT_EQ(read->bytes, name(key).size());
  }
}

TEST(Key, HasALabel) {
  EXPECT_EQ(key_label(Key(U'r', true)), "^R");
  EXPECT_EQ(key_label(Key(U' ')), "Space");
  EXPECT_EQ(key_label(Key(U'u')), "u");
}

TEST(Key, RefusesUnknownNames) {
  EXPECT_FALSE(read_key("<Nonsense>").has_value());
  EXPECT_FALSE(read_key("<Enter").has_value());
  EXPECT_FALSE(read_key("").has_value());
}

TEST(KeyScript, ReadsKeysAndDirectives) {
  using Kind = ScriptStep::Kind;
  const std::vector<ScriptStep> steps =
      parse_key_script("# walk\n2\nwait\nresize 120 35\nj<C-r>\nscreen\n");
  ASSERT_EQ(steps.size(), 6U);
  EXPECT_EQ(steps[0].key, Key(U'2'));
  EXPECT_EQ(steps[1].kind, Kind::Wait);
  EXPECT_EQ(steps[2].kind, Kind::Resize);
  EXPECT_EQ(steps[2].width, 120);
  EXPECT_EQ(steps[2].height, 35);
  EXPECT_EQ(steps[4].key, Key(U'r', true));
  EXPECT_EQ(steps[5].kind, Kind::Dump);
}

TEST(KeyScript, NamesTheLineAtFault) {
  for (const char* bad : {"1\n<Foo>", "1\nresize 0 5", "1\nresize x"}) {
    EXPECT_THAT(
        [&] { (void)parse_key_script(bad); },
        Throws<InputError>(Property(&InputError::where, HasSubstr("line 2"))))
        << bad;
  }
  EXPECT_THROW((void)read_key_script("/nowhere/keys"), InputError);
}

TEST(ColonCommand, ReadsNamesAndTheirBeginnings) {
  using Kind = ColonCommand::Kind;
  EXPECT_EQ(parse_colon_command("q").kind, Kind::Quit);
  EXPECT_EQ(parse_colon_command("undo").kind, Kind::Undo);
  EXPECT_EQ(parse_colon_command(" screen 5 ").number, 5U);
  EXPECT_EQ(parse_colon_command("3").number, 3U);
  EXPECT_EQ(parse_colon_command("dr 12.98").kind, Kind::Drop);
  EXPECT_EQ(parse_colon_command("band 10 60").argument, "10 60");
  EXPECT_EQ(parse_colon_command("toggle 2").kind, Kind::Toggle);
  EXPECT_EQ(parse_colon_command("toggle 2").number, 2U);
  EXPECT_EQ(parse_colon_command("add added-mass@201").argument,
            "added-mass@201");
}

TEST(ColonCommand, RefusesTheRest) {
  for (const char* bad : {"",
                          "nonsense",
                          "re",
                          "add",
                          "screen",
                          "screen 9",
                          "toggle",
                          "toggle 0",
                          "toggle 12"}) {
    EXPECT_THROW((void)parse_colon_command(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace tapfit::tui
