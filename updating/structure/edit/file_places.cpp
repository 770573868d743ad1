#include "updating/structure/edit/file_places.hpp"

#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/include_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& file) {
  std::error_code fault;
  return fs::exists(fs::symlink_status(file, fault));
}

// Where a file that is written may stand.
class FreePlaces {
 public:
  FreePlaces(const fs::path& target, const acquisition::OutputRule& rule)
      : target_(target), rule_(&rule), taken_{resolved_place(target)} {
    if (!rule.force || !acquisition::would_be_replaced(target)) return;
    for (const fs::path& part : deck_files(target)) {
      replaced_.insert(resolved_place(part));
    }
  }

  // Of an original, by its path from the old deck's folder.
  fs::path take(const fs::path& original, const fs::path& deck) {
    fs::path name = original.lexically_normal().lexically_relative(
        deck.lexically_normal().parent_path());
    if (name.empty() || *name.begin() == "..") name = original.filename();
    const fs::path same = target_.parent_path() / name;
    const fs::path own =
        same.parent_path() /
        fmt::format("{}-{}", target_.stem().string(), same.filename().string());
    fs::path place = same;
    if (!takes(same)) place = own;
    if (!takes(place)) {
      place = rule_->free_name(own, [this](const fs::path& free) {
        return !taken_.contains(resolved_place(free));
      });
    }
    taken_.insert(resolved_place(place));
    return place;
  }

 private:
  [[nodiscard]] bool takes(const fs::path& place) const {
    const fs::path resolved = resolved_place(place);
    if (rule_->is_input(place) || taken_.contains(resolved)) return false;
    std::error_code fault;
    return !is_there(place) ||
           (replaced_.contains(resolved) && fs::is_regular_file(place, fault));
  }

  fs::path target_;
  const acquisition::OutputRule* rule_;
  std::set<fs::path> replaced_;
  std::set<fs::path> taken_;
};

FilePlaces placed(const std::vector<EditedFile>& files,
                  const std::vector<bool>& written,
                  const fs::path& target,
                  const acquisition::OutputRule& rule) {
  FilePlaces places{{target}, written, target.parent_path()};
  FreePlaces free(target, rule);
  for (std::size_t k = 1; k < files.size(); ++k) {
    places.at.push_back(
        written[k] ? free.take(files[k].original, files.front().original)
                   : files[k].original);
  }
  return places;
}

// Whether the file as it is leads to what the new deck is made of.
bool may_stay(const EditedFile& file, std::size_t k, const FilePlaces& places) {
  return std::ranges::all_of(file.asks, [&](const auto& ask) {
    const FileAsked& asked = ask.second;
    return !places.written[asked.file] &&
           places.leads(k, asked.name, asked.file);
  });
}

}  // namespace

bool FilePlaces::has(const fs::path& file) const {
  // Its folders may be still to be made, ".." behind them counts all the same.
  const fs::path place = resolved_place(file);
  std::error_code fault;
  if (fs::exists(place, fault)) return true;
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (written[k] && resolved_place(at[k]) == place) return true;
  }
  return false;
}

bool FilePlaces::leads(std::size_t asks,
                       const std::string& name,
                       std::size_t to) const {
  const fs::path found =
      included(at[asks], name, folder, [this](const fs::path& file) {
        return has(file);
      });
  return resolved_place(found) == resolved_place(at[to]);
}

FilePlaces file_places(const std::vector<EditedFile>& files,
                       const fs::path& target,
                       const acquisition::OutputRule& rule) {
  std::vector<bool> written;
  for (const EditedFile& file : files) written.push_back(file.changed);
  written.front() = true;
  while (true) {
    FilePlaces places = placed(files, written, target, rule);
    for (std::size_t k = files.size(); k-- > 1;) {
      if (!written[k] && !may_stay(files[k], k, places)) written[k] = true;
    }
    if (written == places.written) return places;
  }
}

}  // namespace tapfit::structure
