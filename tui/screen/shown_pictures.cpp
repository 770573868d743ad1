#include "tui/screen/shown_pictures.hpp"

#include "tui/screen/kitty_graphics.hpp"
#include "tui/screen/sixel_graphics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tapfit::tui {
namespace {

constexpr const char* keep_cursor = "\0337";
constexpr const char* restore_cursor = "\0338";

std::string cursor_to(const Rect& rect) {
  return fmt::format("\033[{};{}H", rect.y + 1, rect.x + 1);
}

/// Sixels lie in place of glyphs, so none lie where there is one.
PixelPicture beside_glyphs(PixelPicture picture, const Screen& screen) {
  const Rect rect = picture.rect;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      if (screen.at(x, y).glyph != U' ') clear_cell(picture, x, y);
    }
  }
  return picture;
}

/// Its sixels, piece by piece: xterm cuts what is longer than 1000 pixels.
std::string sixels_of(const PixelPicture& picture, const Inks& inks) {
  constexpr int longest = 1000;
  const Rect& all = picture.rect;
  const int columns = std::max(longest / picture.cell.width, 1);
  const int rows = std::max(longest / picture.cell.height, 1);
  std::string text;
  for (int y = all.y; y < all.y + all.height; y += rows) {
    for (int x = all.x; x < all.x + all.width; x += columns) {
      const PixelPicture piece = part_within(picture, {x, y, columns, rows});
      if (piece.blank()) continue;
      text += cursor_to(piece.rect) + sixel_sequence(piece, inks);
    }
  }
  return text;
}

bool lies_in(const PixelPicture& picture, const std::vector<bool>& rows) {
  const auto first = rows.begin() + picture.rect.y;
  return std::find(first, first + picture.rect.height, true) !=
         first + picture.rect.height;
}

void mark(std::vector<bool>& rows, const PixelPicture& picture) {
  const int end = std::min(picture.rect.y + picture.rect.height,
                           static_cast<int>(rows.size()));
  for (int y = picture.rect.y; y < end; ++y) {
    rows[static_cast<std::size_t>(y)] = true;
  }
}

}  // namespace

bool ShownPictures::changed(const Screen& screen, int x, int y) const {
  return !last_ || !last_->area().holds(x, y) ||
         last_->at(x, y) != screen.at(x, y);
}

ShownPictures::Change ShownPictures::show(const Screen& screen) {
  Change change =
      graphics_ == Graphics::Kitty ? show_kitty(screen) : show_sixel(screen);
  last_ = screen;
  if (!change.sequence.empty()) {
    change.sequence = keep_cursor + change.sequence + restore_cursor;
  }
  return change;
}

// The new one is there before the old one goes: nothing flickers.
ShownPictures::Change ShownPictures::show_kitty(const Screen& screen) {
  const auto cells_changed = [&](const Rect& rect) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      for (int x = rect.x; x < rect.x + rect.width; ++x) {
        if (changed(screen, x, y)) return true;
      }
    }
    return false;
  };
  Change change;
  std::vector<Placed> placed;
  for (const PixelPicture& picture : screen.pictures()) {
    if (picture.blank()) continue;
    const auto same = std::ranges::find(placed_, picture, &Placed::picture);
    if (same != placed_.end() && !cells_changed(picture.rect)) {
      placed.push_back(std::move(*same));
      placed_.erase(same);
      continue;
    }
    placed.push_back({picture, ++last_id_});
    change.sequence +=
        cursor_to(picture.rect) + kitty_sequence(picture, inks_, last_id_);
  }
  for (const Placed& old : placed_) change.sequence += kitty_removal(old.id);
  placed_ = std::move(placed);
  return change;
}

std::vector<bool> ShownPictures::changed_rows(
    const Screen& screen, const std::vector<Placed>& placed) const {
  std::vector<bool> rows(static_cast<std::size_t>(screen.height()));
  for (int y = 0; y < screen.height(); ++y) {
    for (int x = 0; x < screen.width(); ++x) {
      if (changed(screen, x, y)) rows[static_cast<std::size_t>(y)] = true;
    }
  }
  const auto mark_others = [&rows](const std::vector<Placed>& ones,
                                   const std::vector<Placed>& others) {
    for (const Placed& one : ones) {
      const auto same =
          std::ranges::find(others, one.picture, &Placed::picture);
      if (same == others.end()) mark(rows, one.picture);
    }
  };
  mark_others(placed_, placed);
  mark_others(placed, placed_);
  return rows;
}

// Sixels are gone only where text is written over them. Whatever changes in a
// row may write over more of it than has changed.
ShownPictures::Change ShownPictures::show_sixel(const Screen& screen) {
  std::vector<Placed> placed;
  for (const PixelPicture& picture : screen.pictures()) {
    PixelPicture seen = beside_glyphs(picture, screen);
    if (!seen.blank()) placed.push_back({std::move(seen), 0});
  }
  std::vector<bool> written = changed_rows(screen, placed);
  std::vector<bool> redrawn(written.size());
  for (const Placed& old : placed_) mark(redrawn, old.picture);
  Change change;
  // Beside a picture that is sent anew another one goes as well.
  std::vector<const PixelPicture*> kept;
  for (const Placed& one : placed) kept.push_back(&one.picture);
  const auto goes = [&written](const PixelPicture* one) {
    return lies_in(*one, written);
  };
  for (auto gone = std::ranges::find_if(kept, goes); gone != kept.end();
       gone = std::ranges::find_if(kept, goes)) {
    mark(written, **gone);
    mark(redrawn, **gone);
    change.sequence += sixels_of(**gone, inks_);
    kept.erase(gone);
  }
  for (std::size_t y = 0; y < written.size(); ++y) {
    if (written[y] && redrawn[y]) change.rows.push_back(static_cast<int>(y));
  }
  placed_ = std::move(placed);
  return change;
}

std::string ShownPictures::remove() {
  last_.reset();
  if (std::exchange(placed_, {}).empty() || graphics_ != Graphics::Kitty) {
    return {};
  }
  return kitty_removal_of_all;
}

}  // namespace tapfit::tui
