#include "tui/screen/kitty_graphics.hpp"

#include "acquisition/readers/inflate.hpp"
#include "tui/screen/base64.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

// More in one sequence is refused.
constexpr std::size_t longest_data = 4096;

/// Red, green, blue and how much of them, for each pixel.
std::string rgba(const PixelPicture& picture, const Inks& inks) {
  std::string bytes(4 * picture.pixels.size(), '\0');
  auto to = bytes.begin();
  for (const Pixel& pixel : picture.pixels) {
    if (pixel.cover > 0) {
      const Rgb& ink = inks[pixel.ink];
      to[0] = static_cast<char>(ink.red);
      to[1] = static_cast<char>(ink.green);
      to[2] = static_cast<char>(ink.blue);
      to[3] = static_cast<char>(pixel.cover);
    }
    to += 4;
  }
  return bytes;
}

}  // namespace

std::string kitty_sequence(const PixelPicture& picture,
                           const Inks& inks,
                           unsigned id) {
  const std::string data = base64(acquisition::deflated(rgba(picture, inks)));
  // a=T: send and show; f=32, o=z: RGBA, packed; s, v: pixels; c, r: cells;
  // z: beneath the text; C=1: the cursor stays; q=2: no answer.
  std::string keys =
      fmt::format("a=T,f=32,o=z,s={},v={},c={},r={},i={},p=1,z=-1,C=1,q=2,",
                  picture.width(),
                  picture.height(),
                  picture.rect.width,
                  picture.rect.height,
                  id);
  std::string sequence;
  for (std::size_t at = 0; at < data.size(); at += longest_data) {
    const bool more = at + longest_data < data.size();
    sequence += fmt::format("\033_G{}m={};{}\033\\",
                            keys,
                            more ? 1 : 0,
                            data.substr(at, longest_data));
    keys = "q=2,";
  }
  return sequence;
}

std::string kitty_removal(unsigned id) {
  return fmt::format("\033_Ga=d,d=I,i={},q=2\033\\", id);
}

}  // namespace tapfit::tui
