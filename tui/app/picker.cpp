#include "tui/app/picker.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/app/recent_bundles.hpp"
#include "tui/options/recordings_folder.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/text_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

constexpr const char* recent = "recent";
constexpr const char* demonstration = "demonstration";
constexpr const char* bundle = "bundle";
constexpr const char* recording = "recording";
constexpr const char* folder = "folder";

bool is_file(const fs::path& path) {
  std::error_code fault;
  return fs::is_regular_file(path, fault);
}

/// A folder with a test.json, or a universal file.
bool is_bundle(const fs::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".uff" || ending == ".unv") return is_file(path);
  return is_file(path / "test.json");
}

/// In the order of their names; hidden ones are left out.
std::vector<fs::path> paths_in(const fs::path& where) {
  std::vector<fs::path> paths;
  std::error_code fault;
  for (fs::directory_iterator at(where, fault), end; !fault && at != end;
       at.increment(fault)) {
    if (!at->path().filename().string().starts_with('.')) {
      paths.push_back(at->path());
    }
  }
  std::ranges::sort(paths);
  return paths;
}

std::optional<fs::path> find_demonstration() {
  const fs::path found = recordings_folder() / "solar-panel-frame";
  std::error_code fault;
  if (!is_bundle(found)) return std::nullopt;
  return fs::weakly_canonical(found, fault);
}

void draw_keys(Screen& screen, int y) {
  screen.fill({0, y, screen.width(), 1}, U' ', {.reverse = true});
  int x = 1;
  for (const auto& [key, what] : {std::pair{"Enter", "open"},
                                  {"j k", "move"},
                                  {"h", "folder above"},
                                  {"/", "filter"},
                                  {"?", "help"},
                                  {"Esc", "start"},
                                  {"q", "quit"}}) {
    x = screen.text(x, y, key, {.bold = true, .reverse = true}) + 1;
    x = screen.text(x, y, what, {.reverse = true}) + 2;
  }
}

constexpr const char* help_text =
    "A test is a folder with test.json, or a universal file. Enter opens it; "
    "work that was begun is taken up where it was left.\n\n"
    "recent: tests opened lately\n"
    "demonstration: a test whose answer is known; tapfit tour leads through "
    "it\n"
    "bundle: a test in this folder\n"
    "recording: a file of time records (CSV, MATLAB, HDF5, netCDF, TDMS, "
    "numpy, WAV, FLAC): Enter shows the test that it makes, a second one "
    "makes it, in a folder beside the file\n"
    "folder: Enter looks into it, h into the one above\n\n"
    "/ shows only what holds the letters that follow; Esc shows all and goes "
    "back to the folder that tapfit was started in.\n"
    "Several files of one test, a deck, or points of other names: tapfit "
    "import --help\n";

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

}  // namespace

PickerStart picker_start() {
  std::error_code fault;
  return {fs::current_path(fault), recent_bundles(), find_demonstration()};
}

Picker::Picker(PickerStart start, const Canvas& canvas)
    : start_(std::move(start)), canvas_(canvas) {
  look_into(start_.folder);
}

void Picker::resize(int width, int height) {
  canvas_.width = width;
  canvas_.height = height;
}

void Picker::look_into(const fs::path& where) {
  folder_ = where;
  entries_.clear();
  list_ = {};
  if (where == start_.folder) {
    for (const fs::path& one : start_.recent) entries_.push_back({recent, one});
    const bool known = std::ranges::find(start_.recent, start_.demonstration) !=
                       start_.recent.end();
    if (start_.demonstration && !known) {
      entries_.push_back({demonstration, *start_.demonstration});
    }
  }
  std::vector<Entry> recordings;
  std::vector<Entry> folders;
  if (where.has_relative_path()) folders.push_back({folder, where / ".."});
  for (const fs::path& path : paths_in(where)) {
    std::error_code fault;
    if (is_bundle(path)) {
      entries_.push_back({bundle, path});
    } else if (is_recording(path)) {
      recordings.push_back({recording, path});
    } else if (fs::is_directory(path, fault)) {
      folders.push_back({folder, path});
    }
  }
  entries_.insert(entries_.end(), recordings.begin(), recordings.end());
  entries_.insert(entries_.end(), folders.begin(), folders.end());
}

Table Picker::table() const {
  Table table{{{""}, {"name"}, {"where"}}, {}};
  for (const Entry& entry : entries_) {
    const bool up = entry.path.filename() == "..";
    const bool far = entry.kind == recent || entry.kind == demonstration;
    const std::string name = up ? ".." : entry.path.filename().string();
    const Style style{.colour = entry.kind == folder ? Colour::Grey
                                                     : Colour::Default};
    table.rows.push_back({{entry.kind,
                           entry.kind == folder ? name + "/" : name,
                           far ? entry.path.parent_path().string() : ""},
                          style});
  }
  return table;
}

void Picker::open_selected() {
  const Table rows = table();
  if (none_shown(rows, list_) || entries_.empty()) return;
  const Entry entry = entries_[settled(rows, list_)];
  if (entry.kind == recording) {
    offer(entry.path);
  } else if (entry.kind != folder) {
    picked_ = entry.path;
  } else {
    look_into(entry.path.filename() == ".." ? folder_.parent_path()
                                            : entry.path);
  }
}

void Picker::show_box(const std::string& title,
                      const std::vector<std::string>& lines) {
  constexpr int widest = 70;
  box_ = Box{.title = title, .lines = {}, .offer = std::nullopt};
  for (const std::string& line : lines) {
    const auto parts = wrapped(line, std::clamp(canvas_.width - 8, 1, widest));
    box_->lines.insert(box_->lines.end(), parts.begin(), parts.end());
    if (parts.empty()) box_->lines.emplace_back();
  }
}

void Picker::offer(const fs::path& file) {
  try {
    const ImportOffer offer = offer_import(file);
    show_box(file.filename().string(), lines_of(offer));
    box_->offer = offer;
  } catch (const InputError& error) {
    refuse(error.what());
  }
}

void Picker::press_box(Key key) {
  const int rows = text_box_rows(canvas_.height);
  const int last = std::max(static_cast<int>(box_->lines.size()) - rows, 0);
  if (key == U'j' || key == keys::down || key == keys::wheel_down) {
    box_->first = std::min(box_->first + 1, last);
  } else if (key == U'k' || key == keys::up || key == keys::wheel_up) {
    box_->first = std::max(box_->first - 1, 0);
  } else if (key == keys::enter && box_->offer) {
    const ImportOffer offer = *std::exchange(box_, std::nullopt)->offer;
    try {
      picked_ = accept(offer);
    } catch (const InputError& error) {
      refuse(error.what());
    }
  } else {
    box_.reset();
  }
}

void Picker::press_filter(Key key) {
  const bool named = key.code >= 0xE000 && key.code <= 0xF8FF;
  if (key == keys::enter) {
    filtering_ = false;
  } else if (key == keys::escape) {
    filtering_ = false;
    list_.filter.clear();
  } else if (key == keys::backspace) {
    if (!list_.filter.empty()) list_.filter.pop_back();
  } else if (!key.ctrl && !named && key.code >= U' ') {
    append_utf8(list_.filter, key.code);
  }
}

void Picker::click(Key key) {
  const Screen screen = draw();
  const Zone* zone = screen.zone_at(key.x, key.y);
  if (zone == nullptr || zone->kind != Zone::Kind::Row) return;
  const bool again = settled(table(), list_) == zone->index;
  list_.selected = zone->index;
  if (again) open_selected();
}

void Picker::press(Key key) {
  if (key == keys::resize || key.code == keys::release) return;
  message_.clear();
  if (box_) return press_box(key);
  if (filtering_) return press_filter(key);
  if (key == U'q' || key == Key(U'c', true)) {
    quit_ = true;
  } else if (key == U'/') {
    filtering_ = true;
  } else if (key == U'?') {
    show_box("help", lines_in(help_text));
  } else if (key == keys::escape) {
    look_into(start_.folder);
  } else if (key == U'h' || key == keys::left || key == keys::backspace) {
    look_into(folder_.parent_path());
  } else if (key == keys::enter || key == U'l' || key == keys::right) {
    open_selected();
  } else if (key.code == keys::click) {
    click(key);
  } else {
    (void)list_key(list_, table(), key, canvas_.height - 8);
  }
}

std::optional<fs::path> Picker::take_picked() {
  return std::exchange(picked_, std::nullopt);
}

void Picker::refuse(const std::string& why) { message_ = why; }

std::string Picker::next_words() const {
  const Table rows = table();
  if (filtering_) return "/" + list_.filter;
  if (none_shown(rows, list_)) return nothing_matches;
  if (entries_.empty()) return "next: h goes to the folder above";
  const Entry& entry = entries_[settled(rows, list_)];
  if (entry.kind == recent) return "next: Enter takes up this work again";
  if (entry.kind == demonstration) {
    return "next: Enter opens the demonstration, a hammer test of a solar "
           "panel "
           "frame";
  }
  if (entry.kind == recording) {
    return "next: Enter shows which test this file makes";
  }
  return entry.kind == bundle ? "next: Enter opens this test"
                              : "next: Enter looks into this folder";
}

Screen Picker::draw() const {
  Screen screen(canvas_);
  const int width = std::max(canvas_.width - 2, 1);
  screen.text(1, 0, "tapfit", {.colour = Colour::Sky, .bold = true});
  screen.text(9,
              0,
              "from hammer taps to a finite element model you can believe",
              {},
              width - 8);
  screen.text(1,
              1,
              fitting({fmt::format("folder: {}", folder_.string()),
                       folder_.filename().string()},
                      width),
              {.colour = Colour::Grey},
              width);
  const int hint = canvas_.height - 4;
  draw_table(screen, {0, 2, canvas_.width, hint - 2}, table(), list_, true);
  screen.text(
      1,
      hint,
      fitting({"several files of one test: tapfit import FILE... makes one "
               "test of them",
               "several files of one test: tapfit import FILE..."},
              width),
      {.colour = Colour::Grey},
      width);
  int y = hint + 1;
  if (message_.empty()) {
    screen.text(1, hint + 2, next_words(), {.colour = Colour::Grey}, width);
  }
  for (const std::string& line : wrapped(message_, width, 2)) {
    screen.text(1, y++, line, {.colour = Colour::Red}, width);
  }
  draw_keys(screen, canvas_.height - 1);
  if (box_) {
    draw_text_box(
        screen, box_->title, box_->lines, {.colour = Colour::Sky}, box_->first);
  }
  return screen;
}

}  // namespace tapfit::tui
