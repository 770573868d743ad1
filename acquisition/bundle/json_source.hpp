// Where a test.json is, and how messages name a place in it.
#pragma once

#include <filesystem>
#include <string>

namespace tapfit::acquisition {

struct JsonSource {
  std::filesystem::path folder;
  std::string name;  ///< of the file

  [[nodiscard]] std::string at(const std::string& place) const {
    return name + ": " + place;
  }
};

}  // namespace tapfit::acquisition
