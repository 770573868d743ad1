#include "tests/project/include_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>

namespace tapfit::project {
namespace {

namespace fs = std::filesystem;

using Graph = std::map<std::string, std::set<std::string>>;

// The C library a <...> header belongs to; empty for any other header.
std::string c_library(const std::string& header) {
  static const std::regex pattern(
      R"(^(?:suitesparse/|ncursesw/|ncurses/|openssl/)?)"
      R"((fftw3|sndfile|matio|hdf5|zlib|ncurses|curses|panel|cholmod|evp)\.(?:h|hh)$)");
  std::smatch match;
  if (!std::regex_match(header, match, pattern)) return {};
  const std::string name = match[1];
  return name == "curses" || name == "panel" ? "ncurses" : name;
}

Graph graph_of(const std::vector<Include>& includes) {
  Graph graph;
  for (const Include& include : includes) {
    const std::string from = pair_of(include.file);
    const std::string to = pair_of(include.header);
    if (include.quoted && from != to) graph[from].insert(to);
  }
  return graph;
}

// All that can be reached from a pair by going on at least once.
std::set<std::string> reached_from(const Graph& graph,
                                   const std::string& start) {
  std::set<std::string> reached;
  std::vector<std::string> open{start};
  while (!open.empty()) {
    const auto next = graph.find(open.back());
    open.pop_back();
    if (next == graph.end()) continue;
    for (const std::string& pair : next->second) {
      if (reached.insert(pair).second) open.push_back(pair);
    }
  }
  return reached;
}

}  // namespace

std::string Include::place() const { return fmt::format("{}:{}", file, line); }

std::string pair_of(const std::string& file) {
  return file.substr(0, file.rfind('.'));
}

std::string folder_of(const std::string& file) {
  return file.substr(0, file.rfind('/'));
}

std::vector<std::string> sources_in(const fs::path& root,
                                    const std::set<std::string>& folders) {
  std::vector<std::string> files;
  for (const std::string& folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".hpp" || extension == ".cpp" || extension == ".h") {
        files.push_back(fs::relative(entry.path(), root).generic_string());
      }
    }
  }
  std::ranges::sort(files);
  return files;
}

std::vector<Include> includes_of(const fs::path& root,
                                 const std::vector<std::string>& files) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*$)");
  std::vector<Include> includes;
  for (const std::string& name : files) {
    std::ifstream file(root / name);
    std::string line;
    std::smatch match;
    for (int number = 1; std::getline(file, line); ++number) {
      if (!std::regex_match(line, match, pattern)) continue;
      includes.push_back({name, number, match[2], match[1] == "\""});
    }
  }
  return includes;
}

std::vector<std::string> broken_walls(const std::vector<Room>& map,
                                      const std::vector<Include>& includes,
                                      const fs::path& root) {
  std::vector<std::string> faults;
  for (const Include& include : includes) {
    if (!include.quoted) continue;
    const std::string target = folder_of(include.header);
    const auto room =
        std::ranges::find(map, folder_of(include.file), &Room::folder);
    const bool known =
        std::ranges::find(map, target, &Room::folder) != map.end();
    if (!fs::exists(root / include.header)) {
      faults.push_back(
          fmt::format("{}: \"{}\" is not there; write it from the "
                      "repository's root",
                      include.place(),
                      include.header));
    } else if (room != map.end() && known && !may_include(map, *room, target)) {
      faults.push_back(fmt::format(
          "{}: {} may not include {}", include.place(), room->folder, target));
    } else if (room != map.end() && !known) {
      faults.push_back(
          fmt::format("{}: {} is no room of the map", include.place(), target));
    }
  }
  return faults;
}

std::vector<std::vector<std::string>> cycles(
    const std::vector<Include>& includes) {
  const Graph graph = graph_of(includes);
  std::map<std::string, std::set<std::string>> reached;
  for (const auto& [pair, next] : graph) {
    reached[pair] = reached_from(graph, pair);
  }
  std::vector<std::vector<std::string>> groups;
  std::set<std::string> seen;
  for (const auto& [pair, all] : reached) {
    if (!all.contains(pair) || seen.contains(pair)) continue;
    std::vector<std::string> group;
    for (const std::string& other : all) {
      if (reached[other].contains(pair)) group.push_back(other);
    }
    seen.insert(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

std::map<std::string, std::set<std::string>> shared_libraries(
    const std::vector<Include>& includes) {
  std::map<std::string, std::set<std::string>> users;
  for (const Include& include : includes) {
    const std::string library = include.quoted ? "" : c_library(include.header);
    if (!library.empty()) users[library].insert(pair_of(include.file));
  }
  std::erase_if(users, [](const auto& one) { return one.second.size() < 2; });
  return users;
}

}  // namespace tapfit::project
