// Which file includes which, and what of that breaks the rules.
#pragma once

#include "tests/project/room_map.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tapfit::project {

/// An include line of the sources.
struct Include {
  std::string file;    ///< from the repository's root
  int line = 0;        ///< from 1
  std::string header;  ///< as written
  bool quoted = false;

  [[nodiscard]] std::string place() const;
};

/// Of all .hpp and .cpp below these folders, ascending.
[[nodiscard]] std::vector<std::string> sources_in(
    const std::filesystem::path& root, const std::set<std::string>& folders);
[[nodiscard]] std::vector<Include> includes_of(
    const std::filesystem::path& root, const std::vector<std::string>& files);

/// "a/b" of "a/b.hpp": a header and its source are one.
[[nodiscard]] std::string pair_of(const std::string& file);
/// "a" of "a/b.hpp".
[[nodiscard]] std::string folder_of(const std::string& file);

/// Includes that no row of the map allows, that lead nowhere, and folders that
/// the map does not know.
[[nodiscard]] std::vector<std::string> broken_walls(
    const std::vector<Room>& map,
    const std::vector<Include>& includes,
    const std::filesystem::path& root);

/// Groups of pairs each of which includes all others by way of some, the names
/// in order.
[[nodiscard]] std::vector<std::vector<std::string>> cycles(
    const std::vector<Include>& includes);

/// C libraries that more than one pair includes, with those pairs.
[[nodiscard]] std::map<std::string, std::set<std::string>> shared_libraries(
    const std::vector<Include>& includes);

}  // namespace tapfit::project
