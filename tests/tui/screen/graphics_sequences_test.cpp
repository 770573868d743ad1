// Pictures as terminals are sent them, decoded again.
#include "tests/support/drawn_screen.hpp"
#include "tui/screen/kitty_graphics.hpp"
#include "tui/screen/shown_pictures.hpp"
#include "tui/screen/sixel_graphics.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tapfit::tui {
namespace {

using end_to_end::DrawnPictures;
using end_to_end::DrawnScreen;
using end_to_end::ShownPixel;

constexpr CellPixels cell{10, 20};

PixelPicture random_picture(const Rect& rect) {
  PixelPicture picture = blank_picture(rect, cell);
  std::mt19937 random(4711);
  for (Pixel& pixel : picture.pixels) {
    pixel.ink = static_cast<std::uint8_t>(random() % 18);
    pixel.cover = static_cast<std::uint8_t>(random() % 256);
  }
  return picture;
}

// A whole colour: sixels have it in per cent.
void expect_ink(const ShownPixel& shown, const Rgb& ink, double tolerance) {
  EXPECT_NEAR(shown.red, ink.red, tolerance);
  EXPECT_NEAR(shown.green, ink.green, tolerance);
  EXPECT_NEAR(shown.blue, ink.blue, tolerance);
}

TEST(KittyGraphics, ShowsEachPixelAsItIs) {
  const PixelPicture picture = random_picture({3, 1, 12, 4});
  const Inks colours = inks(false, Theme::Default);
  DrawnScreen terminal(20, 8, Graphics::Kitty, cell);
  terminal.take("\033[2;4H" + kitty_sequence(picture, colours, 5));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Pixel& pixel = picture.at(x, y);
      const ShownPixel shown = terminal.pictures().at(x + 30, y + 20);
      ASSERT_EQ(shown.cover, pixel.cover);
      if (pixel.cover > 0) expect_ink(shown, colours[pixel.ink], 0.0);
    }
  }
  EXPECT_EQ(terminal.pictures().at(29, 20), ShownPixel{});
  terminal.take(kitty_removal(4));
  EXPECT_EQ(terminal.pictures().placed(), 1U);
  terminal.take(kitty_removal(5));
  EXPECT_EQ(terminal.pictures().placed(), 0U);
}

TEST(SixelGraphics, ShowsEachPixelThatIsHalfCovered) {
  // 45 rows: the last band of six is not full.
  constexpr CellPixels odd{7, 15};
  PixelPicture picture = random_picture({1, 2, 9, 3});
  picture.cell = odd;
  picture.pixels.resize(static_cast<std::size_t>(9 * 7 * 3 * 15));
  const Inks colours = inks(true, Theme::Default);
  DrawnScreen terminal(12, 6, Graphics::Sixel, odd);
  terminal.take("\033[3;2H" + sixel_sequence(picture, colours));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Pixel& pixel = picture.at(x, y);
      const ShownPixel shown = terminal.pictures().at(x + 7, y + 30);
      ASSERT_EQ(shown.cover > 0, pixel.cover >= 128);
      // Half a per cent of 255, and rounding.
      if (shown.cover > 0) expect_ink(shown, colours[pixel.ink], 3.0);
    }
  }
}

// Some terminals have 16 registers, and the first is the background's.
TEST(SixelGraphics, TakesAsFewColourRegistersAsItHasInks) {
  PixelPicture picture = blank_picture({0, 0, 1, 1}, cell);
  picture.at(0, 0) = {17, 255};
  picture.at(1, 0) = {3, 255};
  const std::string sent = sixel_sequence(picture, inks(false, Theme::Default));
  EXPECT_NE(sent.find("#1;2;"), sent.npos);
  EXPECT_NE(sent.find("#2;2;"), sent.npos);
  EXPECT_EQ(sent.find("#17"), sent.npos);
}

TEST(SixelGraphics, AreSentInPiecesThatXtermTakes) {
  Screen screen(150, 60);
  const PixelPicture picture = random_picture({0, 0, 150, 60});
  screen.add(picture);
  ShownPictures pictures(Graphics::Sixel, inks(false, Theme::Default));
  const std::string sent = pictures.show(screen).sequence;
  EXPECT_NE(sent.find("\"1;1;1000;1000"), sent.npos);
  EXPECT_NE(sent.find("\"1;1;500;200"), sent.npos);
  DrawnScreen terminal(150, 60, Graphics::Sixel, cell);
  terminal.take(sent);
  for (int y = 0; y < picture.height(); y += 7) {
    for (int x = 0; x < picture.width(); x += 7) {
      ASSERT_EQ(terminal.pictures().at(x, y).cover > 0,
                picture.at(x, y).cover >= 128);
    }
  }
}

class ShownPicturesTest : public ::testing::TestWithParam<Graphics> {
 protected:
  /// As Terminal does: rows written anew, then what is sent.
  void show(const Screen& screen) {
    const ShownPictures::Change change = pictures.show(screen);
    for (const int y : change.rows) {
      for (int x = 0; x < screen.width(); ++x) write_cell(screen, x, y);
    }
    for (int y = 0; y < screen.height(); ++y) {
      for (int x = 0; x < screen.width(); ++x) {
        if (before.at(x, y) != screen.at(x, y)) write_cell(screen, x, y);
      }
    }
    before = screen;
    terminal.take(change.sequence);
    sent = change.sequence.size();
  }
  void write_cell(const Screen& screen, int x, int y) {
    std::string text =
        "\033[" + std::to_string(y + 1) + ";" + std::to_string(x + 1) + "H";
    text += static_cast<char>(screen.at(x, y).glyph);
    terminal.take(text);
  }
  /// A line in the cells (2, 2) to (17, 2).
  static Screen with_line() {
    Screen screen(20, 6);
    PixelPicture picture = blank_picture({2, 2, 16, 1}, cell);
    for (int x = 0; x < picture.width(); ++x) picture.at(x, 10) = {1, 255};
    screen.add(picture);
    return screen;
  }

  ShownPictures pictures{GetParam(), inks(false, Theme::Default)};
  DrawnScreen terminal{20, 6, GetParam(), cell};
  Screen before{20, 6};
  std::size_t sent = 0;
};

TEST_P(ShownPicturesTest, AreSentOnceAndTakenAway) {
  show(with_line());
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 160);
  EXPECT_EQ(terminal.pictures().at(20, 50).cover, 255);
  show(with_line());
  EXPECT_EQ(sent, 0U);
  show(Screen(20, 6));
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 0);
}

TEST_P(ShownPicturesTest, AreSentAgainWhereTextIsWrittenOverThem) {
  show(with_line());
  Screen screen = with_line();
  screen.text(5, 2, "ab");
  show(screen);
  // Beneath text, or in the cells beside it.
  const bool beneath = GetParam() == Graphics::Kitty;
  EXPECT_EQ(terminal.pictures().drawn_pixels(), beneath ? 160 : 140);
  show(with_line());
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 160);
  // A box covers them.
  screen.fill({4, 1, 6, 3}, U' ');
  show(screen);
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 100);
}

TEST_P(ShownPicturesTest, OfBothPanesStayWhereOneChanges) {
  const auto with_two = [](int row) {
    Screen screen = with_line();
    PixelPicture other = blank_picture({0, 1, 2, 2}, cell);
    other.at(0, row) = {2, 255};
    screen.add(other);
    return screen;
  };
  show(with_two(3));
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 161);
  show(with_two(7));
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 161);
  EXPECT_EQ(terminal.pictures().at(0, 27).cover, 255);
  EXPECT_EQ(terminal.pictures().at(0, 23).cover, 0);
}

TEST_P(ShownPicturesTest, AreAllSentAgainOnceTheTerminalHasLostThem) {
  show(with_line());
  terminal.take(pictures.remove());
  EXPECT_EQ(terminal.pictures().placed(), 0U);
  show(with_line());
  EXPECT_EQ(terminal.pictures().drawn_pixels(), 160);
}

INSTANTIATE_TEST_SUITE_P(Each,
                         ShownPicturesTest,
                         ::testing::Values(Graphics::Kitty, Graphics::Sixel));

}  // namespace
}  // namespace tapfit::tui
