// What the program shows where no bundle is named: those opened lately, the
// demonstration, and the folders to look for others in. Keys in, screens out.
#pragma once

#include "tui/app/import_offer.hpp"
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
    /// "recent", "demonstration", "bundle", "recording", "folder"
    std::string kind;
    std::filesystem::path path;
  };

  /// Over the list until a key leaves it.
  struct Box {
    std::string title;
    std::vector<std::string> lines;
    std::optional<ImportOffer> offer;  ///< which Enter accepts
    int first = 0;
  };

  /// Looks into a folder; at the start, recent bundles come first.
  void look_into(const std::filesystem::path& where);
  void press_filter(Key key);
  void press_box(Key key);
  void show_box(const std::string& title,
                const std::vector<std::string>& lines);
  void offer(const std::filesystem::path& file);
  void click(Key key);
  void open_selected();
  [[nodiscard]] Table table() const;
  [[nodiscard]] std::string next_words() const;

  PickerStart start_;
  Canvas canvas_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  ListState list_;
  std::optional<Box> box_;
  bool filtering_ = false;
  bool quit_ = false;
  std::optional<std::filesystem::path> picked_;
  std::string message_;  ///< of a bundle that was refused
};

}  // namespace tapfit::tui
