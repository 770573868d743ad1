#include "updating/structure/edit/write_layout.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "updating/structure/edit/file_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;

void check_same(const fs::path& deck, const EditedLayout& layout) {
  const bool same = std::ranges::equal(
      layout.source.lines, layout.edited.lines, {}, &PlacedLine::text);
  if (same) return;
  throw InputError(
      "was changed while it was read", deck.string(), "write the deck again");
}

// All beside their targets, then all in their places, the deck itself last.
void write_all(const std::vector<acquisition::FileContent>& files,
               const acquisition::OutputRule& rule) {
  std::vector<std::unique_ptr<acquisition::OutputFile>> outputs;
  for (const acquisition::FileContent& file : files) {
    std::error_code fault;
    if (!outputs.empty())
      fs::create_directories(file.path.parent_path(), fault);
    outputs.push_back(
        std::make_unique<acquisition::OutputFile>(file.path, rule));
    outputs.back()->stream() << file.content;
  }
  for (const auto& output : outputs) output->finish();
  for (std::size_t k = outputs.size(); k-- > 0;) outputs[k]->commit();
}

}  // namespace

WrittenLayout write_layout(const fs::path& deck,
                           const EditedDeck& edited,
                           const fs::path& target,
                           acquisition::OutputRule rule) {
  EditedLayout layout{read_deck_source(deck), edited, {}, {}};
  check_same(deck, layout);
  layout.files = edited_files(layout.source, layout.edited);
  for (const EditedFile& file : layout.files) {
    rule.inputs.push_back(file.original);
  }
  layout.places = file_places(layout.files, target, rule);
  std::vector<acquisition::FileContent> contents;
  WrittenLayout result;
  for (std::size_t k = 0; k < layout.files.size(); ++k) {
    if (!layout.places.written[k]) continue;
    std::optional<std::string> text = file_text(layout, k);
    if (!text) {
      return {{},
              fmt::format("no INCLUDE line can name a file that {} asks for",
                          layout.files[k].original.filename().string())};
    }
    contents.push_back({layout.places.at[k], std::move(*text)});
    result.files.push_back(layout.places.at[k]);
  }
  write_all(contents, rule);
  return result;
}

}  // namespace tapfit::structure
