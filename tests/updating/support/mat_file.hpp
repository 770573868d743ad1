// Real matrices of a MATLAB 5 file, for models that others publish that way.
//
// Source: The MathWorks, "MAT-File Format", version 5.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <zlib.h>

namespace tapfit::structure {

class MatFile {
 public:
  /// Little-endian files; variables may be compressed.
  explicit MatFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    for (std::size_t at = 128; at + 8 <= bytes.size();) {
      const Element e = element(bytes, at);
      take(e.type == compressed ? inflated(e.data) : bytes.substr(at, e.size));
      at += e.size;
    }
  }

  [[nodiscard]] const Eigen::MatrixXd& at(const std::string& name) const {
    return matrices_.at(name);
  }

 private:
  static constexpr std::uint32_t compressed = 15;

  struct Element {
    std::uint32_t type = 0;
    std::string data;
    std::size_t size = 0;  // with its tag and padding
  };

  static std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }

  static Element element(const std::string& bytes, std::size_t at) {
    const std::uint32_t type = word(bytes, at);
    if (type >> 16 != 0) {  // up to four bytes inside the tag
      return {type & 0xffffU, bytes.substr(at + 4, type >> 16), 8};
    }
    const std::size_t size = word(bytes, at + 4);
    const std::size_t padding = type == compressed ? 0 : (8 - size % 8) % 8;
    return {type, bytes.substr(at + 8, size), 8 + size + padding};
  }

  static std::string inflated(const std::string& data) {
    // A matrix of mostly zeros shrinks a thousandfold.
    std::string result(1100 * data.size() + 1024, '\0');
    uLongf size = result.size();
    if (uncompress(reinterpret_cast<Bytef*>(result.data()),
                   &size,
                   reinterpret_cast<const Bytef*>(data.data()),
                   data.size()) != Z_OK) {
      throw std::runtime_error("the MAT file cannot be uncompressed");
    }
    result.resize(size);
    return result;
  }

  void take(const std::string& variable) {
    std::size_t at = 8;
    at += element(variable, at).size;  // flags
    const Element dimensions = element(variable, at);
    at += dimensions.size;
    const Element name = element(variable, at);
    at += name.size;
    Eigen::MatrixXd& A = matrices_[name.data];
    A.resize(word(dimensions.data, 0), word(dimensions.data, 4));
    const Element values = element(variable, at);
    switch (values.type) {
      case 1:
        return fill<std::int8_t>(values.data, A);
      case 2:
        return fill<std::uint8_t>(values.data, A);
      case 3:
        return fill<std::int16_t>(values.data, A);
      case 4:
        return fill<std::uint16_t>(values.data, A);
      case 9:
        return fill<double>(values.data, A);
      default:
        throw std::runtime_error("a MAT file's number type is not known");
    }
  }

  template <typename Number>
  static void fill(const std::string& data, Eigen::MatrixXd& A) {
    for (Eigen::Index i = 0; i < A.size(); ++i) {
      Number value{};
      std::memcpy(&value,
                  data.data() + static_cast<std::size_t>(i) * sizeof value,
                  sizeof value);
      A.data()[i] = static_cast<double>(value);
    }
  }

  std::map<std::string, Eigen::MatrixXd> matrices_;
};

}  // namespace tapfit::structure
