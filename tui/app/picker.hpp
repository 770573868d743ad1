// What the program shows where no bundle is named: those opened lately, the
// demonstration, and the folders to look for others in. Keys in, screens out.
#pragma once

#include "tui/screen/key.hpp"
#include "tui/screen/screen.hpp"
#include "tui/widgets/table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct PickerStart {
  std::filesystem::path folder;  ///< the one that is looked into first
  std::vector<std::filesystem::path> recent;  ///< the latest first
  std::optional<std::filesystem::path> demonstration;
};

/// Where one is, what was opened lately, and where the demonstration came with
/// the program.
[[nodiscard]] PickerStart picker_start();

class Picker {
 public:
  Picker(PickerStart start, const Canvas& canvas);

  void resize(int width, int height);
  void press(Key key);
  [[nodiscard]] Screen draw() const;
  [[nodiscard]] bool quit() const { return quit_; }
  /// The bundle that was chosen, once.
  [[nodiscard]] std::optional<std::filesystem::path> take_picked();
  /// What is told of a bundle that cannot be opened.
  void refuse(const std::string& why);

 private:
  struct Entry {
    std::string kind;  ///< "recent", "demonstration", "bundle", "folder"
    std::filesystem::path path;
  };

  /// Looks into a folder; at the start, recent bundles come first.
  void look_into(const std::filesystem::path& folder);
  void press_filter(Key key);
  void click(Key key);
  void open_selected();
  [[nodiscard]] Table table() const;
  [[nodiscard]] std::string next_words() const;

  PickerStart start_;
  Canvas canvas_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  ListState list_;
  bool filtering_ = false;
  bool quit_ = false;
  std::optional<std::filesystem::path> picked_;
  std::string message_;  ///< of a bundle that was refused
};

}  // namespace tapfit::tui
