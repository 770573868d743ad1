#include "updating/structure/edit/edited_files.hpp"

#include <algorithm>
#include <system_error>
#include <tuple>
#include <utility>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;

// Each file at each place where it is asked for.
std::vector<EditedFile> files_by_place(const DeckSource& source,
                                       const EditedDeck& edited) {
  std::vector<EditedFile> files;
  for (const DeckFile& file : source.files) {
    std::error_code fault;
    const fs::path whole = fs::absolute(file.path, fault);
    files.push_back({fault ? file.path : whole, {}, {}, false});
  }
  for (std::size_t k = 0; k < source.origins.size(); ++k) {
    EditedFile& file = files[source.origins[k].file];
    file.lines.push_back(k);
    file.changed = file.changed || edited.replaced.contains(k);
  }
  for (std::size_t k = 1; k < source.files.size(); ++k) {
    const std::size_t line = source.files[k].asked_at;
    files[source.origins[line].file].asks[line] = {k, source.files[k].name};
  }
  return files;
}

// What a file says: its own changes by their line in it, and what it asks for.
using Saying = std::tuple<fs::path,
                          std::vector<std::pair<int, std::vector<std::string>>>,
                          std::vector<std::size_t>>;

Saying saying_of(const EditedFile& file,
                 const DeckSource& source,
                 const EditedDeck& edited) {
  Saying saying;
  std::get<0>(saying) = resolved_place(file.original);
  for (const std::size_t line : file.lines) {
    const auto other = edited.replaced.find(line);
    if (other == edited.replaced.end()) continue;
    std::get<1>(saying).emplace_back(source.origins[line].first, other->second);
  }
  for (const auto& [line, asked] : file.asks) {
    std::get<2>(saying).push_back(asked.file);
  }
  return saying;
}

}  // namespace

fs::path resolved_place(const fs::path& file) {
  std::error_code fault;
  const fs::path whole = fs::absolute(file, fault);
  if (fault) return file;
  const fs::path resolved = fs::weakly_canonical(whole, fault);
  return fault ? file : resolved;
}

std::vector<EditedFile> edited_files(const DeckSource& source,
                                     const EditedDeck& edited) {
  std::vector<EditedFile> all = files_by_place(source, edited);
  // From the last one on: what a file asks for stands behind it.
  std::vector<EditedFile> files;
  std::map<Saying, std::size_t> known;
  std::vector<std::size_t> place(all.size());
  for (std::size_t k = all.size(); k-- > 0;) {
    for (auto& [line, asked] : all[k].asks) asked.file = place[asked.file];
    const auto [same, is_new] =
        known.emplace(saying_of(all[k], source, edited), files.size());
    place[k] = same->second;
    if (is_new) files.push_back(std::move(all[k]));
  }
  std::ranges::reverse(files);
  for (EditedFile& file : files) {
    for (auto& [line, asked] : file.asks) {
      asked.file = files.size() - 1 - asked.file;
    }
  }
  return files;
}

}  // namespace tapfit::structure
