#include "tests/project/room_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>

namespace tapfit::project {
namespace {

namespace fs = std::filesystem;

std::string parent(const std::string& folder) {
  const std::size_t slash = folder.rfind('/');
  return slash == std::string::npos ? "" : folder.substr(0, slash);
}

bool is_within(const std::string& folder, const std::string& whole) {
  return folder == whole || folder.starts_with(whole + "/");
}

// What a name may stand for, seen from a room: beside it, in a folder around
// it, or as written.
std::vector<std::string> meanings(const Room& room, const std::string& name) {
  std::vector<std::string> result;
  for (std::string at = parent(room.folder); !at.empty(); at = parent(at)) {
    result.push_back(at + "/" + name);
  }
  result.push_back(name);
  return result;
}

// Whether the name, taken as written there, opens the room.
bool opens(const std::string& meaning, const Room& room) {
  return room.folder == meaning ||
         (!room.aside && is_within(room.folder, meaning));
}

bool opens_any(const std::vector<Room>& map,
               const Room& from,
               const std::string& name,
               const std::string& folder) {
  for (const std::string& meaning : meanings(from, name)) {
    const bool known = std::ranges::any_of(
        map, [&](const Room& room) { return is_within(room.folder, meaning); });
    if (!known) continue;
    return std::ranges::any_of(map, [&](const Room& room) {
      return room.folder == folder && opens(meaning, room);
    });
  }
  return false;
}

bool holds_sources(const fs::path& folder) {
  return std::ranges::any_of(
      fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        const fs::path extension = entry.path().extension();
        return extension == ".hpp" || extension == ".cpp";
      });
}

}  // namespace

std::vector<Room> read_room_map(const fs::path& contributing) {
  static const std::regex row(
      R"(^\| *`((?:acquisition|signal|modal|updating|tui)[a-z_/]*)/` *\|)"
      R"([^|]*\|([^|]*)\|\s*$)");
  static const std::regex word(R"([a-z_/]+)");
  std::vector<Room> map;
  std::ifstream file(contributing);
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (!std::regex_match(line, match, row)) continue;
    Room room{match[1]};
    const std::string names = match[2];
    for (std::sregex_iterator it(names.begin(), names.end(), word), end;
         it != end;
         ++it) {
      if (it->str() == "aside") {
        room.aside = true;
      } else if (it->str() != "nothing") {
        room.may_include.push_back(it->str());
      }
    }
    map.push_back(std::move(room));
  }
  return map;
}

bool may_include(const std::vector<Room>& map,
                 const Room& room,
                 const std::string& folder) {
  return folder == room.folder ||
         std::ranges::any_of(room.may_include, [&](const std::string& name) {
           return opens_any(map, room, name, folder);
         });
}

std::vector<std::string> faults_of_map(const std::vector<Room>& map,
                                       const fs::path& root) {
  std::vector<std::string> faults;
  for (auto room = map.begin(); room != map.end(); ++room) {
    const fs::path folder = root / room->folder;
    if (!fs::is_directory(folder) || !holds_sources(folder)) {
      faults.push_back(
          fmt::format("the map's room {} holds no sources", room->folder));
    }
    const std::vector<Room> above(map.begin(), room);
    for (const std::string& name : room->may_include) {
      const bool known = std::ranges::any_of(above, [&](const Room& other) {
        return opens_any(above, *room, name, other.folder);
      });
      if (known) continue;
      faults.push_back(
          fmt::format("the map lets {} include {}, which is no room above it",
                      room->folder,
                      name));
    }
  }
  return faults;
}

}  // namespace tapfit::project
