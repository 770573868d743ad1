#include "acquisition/instruments/tdms_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/instruments/tdms_scale.hpp"
#include "acquisition/instruments/tdms_segments.hpp"
#include "acquisition/readers/mapped_file.hpp"

#include <fstream>
#include <string>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Samples = std::vector<std::vector<double>>;  // by object

std::string tdms_mark(const std::filesystem::path& file) {
  std::string bytes(4, '\0');
  std::ifstream in = open_input(file);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

// "Group/Channel" of "/'Group'/'Channel'", where a quote in a name is doubled.
std::string plain_path(const std::string& path) {
  std::string plain;
  bool quoted = false;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool doubled =
        quoted && path[k] == '\'' && k + 1 < path.size() && path[k + 1] == '\'';
    if (doubled) {
      plain += path[k++];
    } else if (path[k] == '\'') {
      quoted = !quoted;
    } else if (quoted || !plain.empty()) {
      plain += path[k];
    }
  }
  return plain;
}

// Appends a piece to its channel, as far as memory goes.
class Collect {
 public:
  explicit Collect(const std::filesystem::path& file) : room_(file) {}

  void operator()(const TdmsPiece& piece) {
    room_.take("", static_cast<double>(piece.count));
    if (samples_.size() <= piece.object) samples_.resize(piece.object + 1);
    std::vector<double>& to = samples_[piece.object];
    to.resize(to.size() + piece.count);
    decode(piece.bytes,
           piece.stride,
           piece.type,
           piece.order,
           piece.count,
           to.data() + (to.size() - piece.count));
  }

  [[nodiscard]] Eigen::MatrixXd take(std::size_t object) {
    std::vector<double> samples = std::move(samples_.at(object));
    return Eigen::Map<const Eigen::VectorXd>(
        samples.data(), static_cast<Index>(samples.size()));
  }

 private:
  ArrayRoom room_;
  Samples samples_;
};

void add_properties(const TdmsObject& object,
                    const std::string& path,
                    std::vector<NamedArray>& arrays) {
  const std::string prefix = path.empty() ? "" : path + "@";
  for (const auto& [name, value] : object.properties) {
    NamedArray array{.name = prefix + name};
    if (const double* number = std::get_if<double>(&value)) {
      array.kind = NamedArray::Kind::Numbers;
      array.values = Eigen::MatrixXd::Constant(1, 1, *number);
    } else {
      array.kind = NamedArray::Kind::Text;
      array.texts = {std::get<std::string>(value)};
    }
    arrays.push_back(std::move(array));
  }
}

}  // namespace

bool is_tdms(const std::filesystem::path& file) {
  const std::string mark = tdms_mark(file);
  return mark == "TDSm" || mark == "TDSh";
}

std::vector<NamedArray> read_tdms_arrays(const std::filesystem::path& file) {
  if (tdms_mark(file) == "TDSh") {
    throw InputError("is the index of a TDMS file, without samples",
                     file.string(),
                     "name the file that ends in .tdms");
  }
  const MappedFile mapped(file);
  return mapped.reading([&] {
    Collect samples(file);
    const std::vector<TdmsObject> objects = read_tdms_segments(
        mapped.text(), file, [&](const TdmsPiece& piece) { samples(piece); });
    std::vector<NamedArray> arrays;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const std::string path = plain_path(objects[k].path);
      if (objects[k].has_numbers) {
        NamedArray array{.name = path, .kind = NamedArray::Kind::Numbers};
        array.values = samples.take(k);
        apply_tdms_scales(objects[k], file, array.values);
        arrays.push_back(std::move(array));
      }
      add_properties(objects[k], path, arrays);
    }
    return arrays;
  });
}

}  // namespace tapfit::acquisition
