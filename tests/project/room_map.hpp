// The rooms of the sources and what each may include, as CONTRIBUTING.md draws
// them: the rows of its tables whose first cell is a folder, such as
//
//   | `signal/spectra/` | windows, FFT | acquisition, frf_set |
//
// A name is a room of the same folder, a whole folder ("acquisition"), or both
// ("acquisition/simulator"). A whole folder does not open the rooms that are
// marked "aside": those are to be named.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::project {

struct Room {
  std::string folder;                         ///< "signal/spectra"
  std::vector<std::string> may_include = {};  ///< as written
  bool aside = false;
};

/// The map's rows in their order.
[[nodiscard]] std::vector<Room> read_room_map(
    const std::filesystem::path& contributing);

/// Whether a room may include files of a folder. Its own it always may.
[[nodiscard]] bool may_include(const std::vector<Room>& map,
                               const Room& room,
                               const std::string& folder);

/// What is wrong with the map itself: rooms that are not there or hold no
/// sources, names that are no rooms or come further down.
[[nodiscard]] std::vector<std::string> faults_of_map(
    const std::vector<Room>& map, const std::filesystem::path& root);

}  // namespace tapfit::project
