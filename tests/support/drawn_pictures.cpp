#include "tests/support/drawn_pictures.hpp"

#include "acquisition/readers/inflate.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace tapfit::end_to_end {
namespace {

using Keys = std::map<std::string, std::string>;

Keys keys_in(std::string_view text) {
  Keys keys;
  std::istringstream parts{std::string(text)};
  std::string part;
  while (std::getline(parts, part, ',')) {
    const std::size_t equal = part.find('=');
    keys[part.substr(0, equal)] = part.substr(equal + 1);
  }
  return keys;
}

int number(const Keys& keys, const std::string& key) {
  const auto found = keys.find(key);
  return found == keys.end() ? 0 : std::atoi(found->second.c_str());
}

std::string unpacked_base64(std::string_view text) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t value = letters.find(c);
    if (value == letters.npos) throw std::runtime_error("no base 64");
    bits = bits << 6U | static_cast<unsigned>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& packed, std::size_t size) {
  std::istringstream in(packed);
  acquisition::Inflate inflate(
      in, packed.size(), acquisition::Inflate::Wrapping::Zlib);
  std::string bytes(size, '\0');
  const auto there =
      inflate.unpack(reinterpret_cast<unsigned char*>(bytes.data()), size);
  if (there != size) throw std::runtime_error("too few pixels are sent");
  return bytes;
}

/// The number at the front, taken off.
int take_number(std::string_view& text) {
  int value = 0;
  while (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0]))) {
    value = 10 * value + text[0] - '0';
    text.remove_prefix(1);
  }
  return value;
}

std::vector<int> take_numbers(std::string_view& text) {
  std::vector<int> numbers{take_number(text)};
  while (text.starts_with(';')) {
    text.remove_prefix(1);
    numbers.push_back(take_number(text));
  }
  return numbers;
}

}  // namespace

DrawnPictures::DrawnPictures(int columns, int rows, tui::CellPixels cell)
    : columns_(columns), rows_(rows), cell_(cell) {
  sixels_.resize(static_cast<std::size_t>(width()) *
                 static_cast<std::size_t>(height()));
}

ShownPixel DrawnPictures::at(int x, int y) const {
  const ShownPixel sixel =
      sixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
              static_cast<std::size_t>(x)];
  if (sixel.cover > 0) return sixel;
  ShownPixel seen;
  for (const auto& [id, one] : placed_) {
    const int column = x - one.x;
    const int row = y - one.y;
    if (column < 0 || row < 0 || column >= one.width || row >= one.height) {
      continue;
    }
    const auto first = 4 * static_cast<std::size_t>(row * one.width + column);
    const auto byte = [&](std::size_t i) {
      return static_cast<int>(static_cast<unsigned char>(one.rgba[first + i]));
    };
    if (byte(3) > 0) seen = {byte(0), byte(1), byte(2), byte(3)};
  }
  return seen;
}

int DrawnPictures::drawn_pixels() const {
  int count = 0;
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) count += at(x, y).cover >= 128 ? 1 : 0;
  }
  return count;
}

void DrawnPictures::take_kitty(std::string_view text, int column, int row) {
  const std::size_t semicolon = text.find(';');
  Keys keys = keys_in(text.substr(0, semicolon));
  if (keys["a"] == "q") return;
  if (keys["a"] == "d") {
    if (keys["d"] == "A") placed_.clear();
    if (keys["d"] == "I") placed_.erase(number(keys, "i"));
    return;
  }
  if (data_.empty()) keys_ = keys;
  const std::string_view data = text.substr(semicolon + 1);
  if (data.size() > 4096) throw std::runtime_error("a chunk is too long");
  data_ += data;
  if (keys["m"] == "1") return;
  if (keys_["a"] != "T" || keys_["f"] != "32" || keys_["o"] != "z") {
    throw std::runtime_error("not what is known here");
  }
  Placed one{column * cell_.width,
             row * cell_.height,
             number(keys_, "s"),
             number(keys_, "v"),
             {}};
  if (one.width != number(keys_, "c") * cell_.width ||
      one.height != number(keys_, "r") * cell_.height) {
    throw std::runtime_error("cells are of another size");
  }
  one.rgba = inflated(unpacked_base64(data_),
                      static_cast<std::size_t>(4 * one.width * one.height));
  placed_[number(keys_, "i")] = std::move(one);
  data_.clear();
}

void DrawnPictures::put_sixel(int x,
                              int y,
                              unsigned bits,
                              const ShownPixel& ink) {
  for (int row = 0; row < 6; ++row) {
    if ((bits >> static_cast<unsigned>(row) & 1U) == 0) continue;
    if (x >= width() || y + row >= height()) {
      throw std::runtime_error("a sixel is outside");
    }
    sixels_[static_cast<std::size_t>(y + row) *
                static_cast<std::size_t>(width()) +
            static_cast<std::size_t>(x)] = ink;
  }
}

void DrawnPictures::take_sixel(std::string_view text, int column, int row) {
  const std::vector<int> parameters = take_numbers(text);
  if (parameters.size() < 2 || parameters[1] != 1 || !text.starts_with('q')) {
    throw std::runtime_error("no sixels that leave the rest as it is");
  }
  text.remove_prefix(1);
  const int left = column * cell_.width;
  int x = left;
  int y = row * cell_.height;
  std::map<int, ShownPixel> inks;
  ShownPixel ink;
  while (!text.empty()) {
    const char c = text[0];
    text.remove_prefix(1);
    if (c == '"') {
      take_numbers(text);
    } else if (c == '#') {
      const std::vector<int> said = take_numbers(text);
      if (said.size() == 5) {
        inks[said[0]] = {
            said[2] * 255 / 100, said[3] * 255 / 100, said[4] * 255 / 100, 255};
      }
      ink = inks.at(said[0]);
    } else if (c == '$') {
      x = left;
    } else if (c == '-') {
      x = left;
      y += 6;
    } else {
      int count = 1;
      char columns = c;
      if (c == '!') {
        count = take_number(text);
        columns = text[0];
        text.remove_prefix(1);
      }
      for (int i = 0; i < count; ++i) {
        put_sixel(x++, y, static_cast<unsigned>(columns - '?'), ink);
      }
    }
  }
}

void DrawnPictures::write_cell(int column, int row) {
  for (int y = row * cell_.height; y < (row + 1) * cell_.height; ++y) {
    for (int x = column * cell_.width; x < (column + 1) * cell_.width; ++x) {
      sixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
              static_cast<std::size_t>(x)] = {};
    }
  }
}

void DrawnPictures::clear() {
  placed_.clear();
  std::ranges::fill(sixels_, ShownPixel{});
}

}  // namespace tapfit::end_to_end
