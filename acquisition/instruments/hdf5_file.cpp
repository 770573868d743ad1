#include "acquisition/instruments/hdf5_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/readers/own_process.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <hdf5.h>
#include <string>
#include <string_view>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Anything of the library, closed at its end; what could not be had is empty.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// A dataset or an attribute.
struct Content {
  hid_t id;
  bool attribute;

  [[nodiscard]] Handle type() const {
    return {attribute ? H5Aget_type(id) : H5Dget_type(id), &H5Tclose};
  }
  [[nodiscard]] Handle space() const {
    return {attribute ? H5Aget_space(id) : H5Dget_space(id), &H5Sclose};
  }
  [[nodiscard]] bool read(hid_t memory, void* to) const {
    return attribute
               ? H5Aread(id, memory, to) >= 0
               : H5Dread(id, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) >= 0;
  }
  // Whether its values lie in this file.
  [[nodiscard]] bool is_here() const {
    if (attribute) return true;
    const Handle list(H5Dget_create_plist(id), &H5Pclose);
    return list && H5Pget_layout(list.id()) != H5D_VIRTUAL &&
           H5Pget_external_count(list.id()) <= 0;
  }
};

// Rows and columns of up to two dimensions; those of one do not count.
struct Shape {
  hsize_t rows = 1;
  hsize_t columns = 1;
  bool known = false;

  explicit Shape(const Handle& space) {
    std::array<hsize_t, H5S_MAX_RANK> dims{};
    const int rank = space ? H5Sget_simple_extent_ndims(space.id()) : -1;
    if (rank < 0 || H5Sget_simple_extent_type(space.id()) == H5S_NULL) return;
    H5Sget_simple_extent_dims(space.id(), dims.data(), nullptr);
    constexpr hsize_t longest_side = hsize_t{1} << 62U;
    int sides = 0;
    for (int k = 0; k < rank; ++k) {
      const hsize_t side = dims[static_cast<std::size_t>(k)];
      if (side > longest_side) return;  // beside a side of none
      if (side == 1) continue;
      ++sides;
      rows = columns;
      columns = side;
    }
    known = sides <= 2;
  }
  [[nodiscard]] double values() const {
    return static_cast<double>(rows) * static_cast<double>(columns);
  }
};

// Rows stand together in the file, columns in a matrix.
void read_numbers(const Content& content, const Shape& shape, NamedArray& to) {
  to.values.resize(static_cast<Index>(shape.columns),
                   static_cast<Index>(shape.rows));
  const bool read = to.values.size() == 0 ||
                    content.read(H5T_NATIVE_DOUBLE, to.values.data());
  to.kind = read ? NamedArray::Kind::Numbers : NamedArray::Kind::Damaged;
  if (!read) to.values.resize(0, 0);
}

std::string plain(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  const std::size_t end = text.find_last_not_of(' ');
  return as_utf8(text.substr(0, end + 1));
}

void read_varying_texts(const Content& content,
                        const Handle& type,
                        std::size_t count,
                        NamedArray& to) {
  const Handle memory(H5Tcopy(H5T_C_S1), &H5Tclose);
  H5Tset_size(memory.id(), H5T_VARIABLE);
  H5Tset_cset(memory.id(), H5Tget_cset(type.id()));
  std::vector<char*> texts(count, nullptr);
  if (!content.read(memory.id(), texts.data())) return;
  to.kind = NamedArray::Kind::Text;
  for (const char* text : texts) {
    to.texts.push_back(text == nullptr ? "" : plain(text));
  }
  const Handle space = content.space();
  H5Dvlen_reclaim(memory.id(), space.id(), H5P_DEFAULT, texts.data());
}

void read_fixed_texts(const Content& content,
                      const Handle& type,
                      std::size_t count,
                      NamedArray& to) {
  const std::size_t length = H5Tget_size(type.id());
  std::string bytes(count * length, '\0');
  if (!content.read(type.id(), bytes.data())) return;
  to.kind = NamedArray::Kind::Text;
  for (std::size_t k = 0; k < count; ++k) {
    to.texts.push_back(plain(bytes.substr(k * length, length)));
  }
}

void read_texts(const Content& content,
                const Handle& type,
                const Shape& shape,
                NamedArray& to) {
  constexpr double most_texts = 1e5;  // of lists of channels
  constexpr std::size_t longest = 1024;
  const auto count = static_cast<std::size_t>(shape.rows * shape.columns);
  if (shape.values() > most_texts) return;
  if (H5Tis_variable_str(type.id()) > 0) {
    read_varying_texts(content, type, count, to);
  } else if (H5Tget_size(type.id()) <= longest || count == 1) {
    read_fixed_texts(content, type, count, to);
  }
}

// What else there is in a file is listed without its content.
NamedArray read_content(const Content& content,
                        const std::string& name,
                        ArrayRoom& room) {
  NamedArray array{.name = name};
  const Handle type = content.type();
  const Shape shape(content.space());
  if (!type || !shape.known || !content.is_here()) return array;
  const H5T_class_t kind = H5Tget_class(type.id());
  if (kind == H5T_INTEGER || kind == H5T_FLOAT) {
    room.take(name, shape.values());
    read_numbers(content, shape, array);
  } else if (kind == H5T_STRING) {
    read_texts(content, type, shape, array);
  }
  return array;
}

// Goes through the groups of a file and sends what they hold.
class Walk {
 public:
  Walk(const std::filesystem::path& file, std::FILE* out)
      : room_(file), out_(out) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as groups lie in each other
  void go(hid_t group, const std::string& path, int depth) {
    constexpr int deepest = 12;
    send_attributes(group, path);
    if (depth > deepest) return;
    H5G_info_t info{};
    if (H5Gget_info(group, &info) < 0) return;
    for (hsize_t k = 0; k < info.nlinks && may_go_on(); ++k) {
      const std::string name = link_name(group, k);
      const std::string inner = path.empty() ? name : path + "/" + name;
      if (!name.empty()) open(group, name, inner, depth);
    }
  }

 private:
  // A group that lies in itself has no end.
  bool may_go_on() {
    constexpr int most_objects = 20000;
    return ++seen_ <= most_objects;
  }

  // Empty for links that are none of this file.
  static std::string link_name(hid_t group, hsize_t k) {
    H5L_info_t info{};
    if (H5Lget_info_by_idx(
            group, ".", H5_INDEX_NAME, H5_ITER_INC, k, &info, H5P_DEFAULT) <
            0 ||
        info.type != H5L_TYPE_HARD) {
      return {};
    }
    std::array<char, 1024> name{};
    const ssize_t length = H5Lget_name_by_idx(group,
                                              ".",
                                              H5_INDEX_NAME,
                                              H5_ITER_INC,
                                              k,
                                              name.data(),
                                              name.size(),
                                              H5P_DEFAULT);
    const bool fits =
        length > 0 && static_cast<std::size_t>(length) < name.size();
    return fits ? std::string(name.data()) : std::string();
  }

  void open(hid_t group,
            const std::string& name,
            const std::string& path,
            int depth) {
    const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), &H5Oclose);
    const H5I_type_t kind = object ? H5Iget_type(object.id()) : H5I_BADID;
    if (kind == H5I_GROUP) {
      go(object.id(), path, depth + 1);
    } else if (kind == H5I_DATASET) {
      send_array(read_content({object.id(), false}, path, room_), out_);
      send_attributes(object.id(), path);
    } else if (!object) {
      send_array({.name = path, .kind = NamedArray::Kind::Damaged}, out_);
    }
  }

  void send_attributes(hid_t object, const std::string& path) {
    const std::string prefix = path.empty() ? "" : path + "@";
    const int count = H5Aget_num_attrs(object);
    for (int k = 0; k < count && may_go_on(); ++k) {
      const Handle attribute(H5Aopen_by_idx(object,
                                            ".",
                                            H5_INDEX_NAME,
                                            H5_ITER_INC,
                                            static_cast<hsize_t>(k),
                                            H5P_DEFAULT,
                                            H5P_DEFAULT),
                             &H5Aclose);
      std::array<char, 1024> name{};
      if (!attribute ||
          H5Aget_name(attribute.id(), name.size(), name.data()) <= 0) {
        continue;
      }
      const NamedArray array =
          read_content({attribute.id(), true}, prefix + name.data(), room_);
      if (array.kind != NamedArray::Kind::Other) send_array(array, out_);
    }
  }

  ArrayRoom room_;
  std::FILE* out_;
  int seen_ = 0;
};

void walk_file(const std::filesystem::path& file, std::FILE* out) {
  // A lock needs rights that reading does not.
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle open(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                    &H5Fclose);
  if (!open) throw_damaged(file, "the HDF5 file");
  const Handle root(H5Gopen2(open.id(), "/", H5P_DEFAULT), &H5Gclose);
  if (!root) throw_damaged(file, "the HDF5 file");
  Walk(file, out).go(root.id(), "", 0);
}

}  // namespace

bool is_hdf5(const std::filesystem::path& file) {
  constexpr std::string_view mark("\x89HDF\r\n\x1a\n", 8);
  std::ifstream in = open_input(file);
  std::string begin(mark.size(), '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return in && begin == mark;
}

std::vector<NamedArray> read_hdf5_arrays(const std::filesystem::path& file,
                                         const Progress& progress) {
  std::vector<NamedArray> arrays;
  in_own_process(
      file,
      [&](std::FILE* out) { walk_file(file, out); },
      [&](std::FILE* in) { arrays = receive_arrays(in); },
      progress.stop);
  return arrays;
}

}  // namespace tapfit::acquisition
