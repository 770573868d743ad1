#include "acquisition/instruments/tdms_segments.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/instruments/byte_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace tapfit::acquisition {
namespace {

// Bits of the contents.
constexpr std::uint32_t with_metadata = 1U << 1U;
constexpr std::uint32_t with_new_list = 1U << 2U;
constexpr std::uint32_t with_raw_data = 1U << 3U;
constexpr std::uint32_t interleaved = 1U << 5U;
constexpr std::uint32_t big_endian = 1U << 6U;
constexpr std::uint32_t of_daqmx = 1U << 7U;

// Codes of types besides numbers.
constexpr std::uint32_t string_type = 0x20;
constexpr std::uint32_t boolean_type = 0x21;
constexpr std::uint32_t time_type = 0x44;

constexpr std::uint64_t open_end = ~std::uint64_t{0};

std::optional<NumberType> tdms_number_type(std::uint32_t code) {
  switch (code) {
    case 1:
      return NumberType::Int8;
    case 2:
      return NumberType::Int16;
    case 3:
      return NumberType::Int32;
    case 4:
      return NumberType::Int64;
    case 5:
    case boolean_type:
      return NumberType::Uint8;
    case 6:
      return NumberType::Uint16;
    case 7:
      return NumberType::Uint32;
    case 8:
      return NumberType::Uint64;
    case 9:
    case 0x19:  // with a unit, which is a property
      return NumberType::Float32;
    case 10:
    case 0x1a:
      return NumberType::Float64;
    default:
      return std::nullopt;
  }
}

// Of a value that is no number here; 0 where it is not known.
std::size_t width_of_others(std::uint32_t code) {
  switch (code) {
    case 0x08000c:  // complex
      return 8;
    case 11:  // of extended precision
    case 0x1b:
    case time_type:
    case 0x10000d:
      return 16;
    default:
      return 0;
  }
}

// An object's values in each chunk of a segment.
struct RawIndex {
  std::optional<NumberType> type;  ///< empty: to be passed over
  std::size_t width = 0;           ///< bytes of a value; 0: they differ
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
};

struct LeadIn {
  std::uint32_t contents = 0;
  std::uint64_t raw_begin = 0;
  std::uint64_t end = 0;

  [[nodiscard]] bool has(std::uint32_t bit) const {
    return (contents & bit) != 0;
  }
};

class TdmsReader {
 public:
  TdmsReader(std::string_view bytes,
             const std::filesystem::path& file,
             const std::function<void(const TdmsPiece&)>& take)
      : bytes_(bytes), file_(file), take_(take), cursor_(bytes, file) {}

  std::vector<TdmsObject> read() {
    while (cursor_.left() > 0) {
      const LeadIn lead = read_lead_in();
      if (lead.has(with_metadata)) read_metadata(lead);
      if (lead.has(with_raw_data)) read_raw_data(lead);
      cursor_.go_to(lead.end);
    }
    return std::move(objects_);
  }

 private:
  struct Listed {
    std::size_t object = 0;
    RawIndex index;
  };

  LeadIn read_lead_in() {
    constexpr std::uint64_t length = 28;
    const std::size_t begin = cursor_.at();
    cursor_.set_order(ByteOrder::Little);
    if (cursor_.bytes(4) != "TDSm") {
      throw InputError("is no TDMS file, or damaged there",
                       place(begin),
                       "copy the file again, or export it anew");
    }
    LeadIn lead;
    lead.contents = cursor_.number<std::uint32_t>();
    order_ = lead.has(big_endian) ? ByteOrder::Big : ByteOrder::Little;
    cursor_.set_order(order_);
    (void)cursor_.number<std::uint32_t>();  // version
    const auto next = cursor_.number<std::uint64_t>();
    const auto raw = cursor_.number<std::uint64_t>();
    // A recorder that did not come to its end leaves it open.
    lead.end = next == open_end ? bytes_.size() : begin + length + next;
    lead.raw_begin = begin + length + raw;
    const bool in_order = raw <= next && lead.raw_begin <= lead.end;
    if (!in_order || lead.end > bytes_.size() || lead.end < begin + length) {
      throw InputError("ends early: a segment is longer than the file",
                       place(begin),
                       "copy the file again, or export it anew");
    }
    return lead;
  }

  void read_metadata(const LeadIn& lead) {
    if (lead.has(with_new_list)) list_.clear();
    const auto count = cursor_.number<std::uint32_t>();
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::size_t object = object_of(as_utf8(cursor_.text()));
      read_index(object, lead);
      const auto properties = cursor_.number<std::uint32_t>();
      for (std::uint32_t p = 0; p < properties; ++p) {
        read_property(objects_[object]);
      }
    }
    sum_up_chunk();
  }

  void sum_up_chunk() {
    chunk_ = 0;
    with_values_.clear();
    for (const Listed& listed : list_) {
      if (listed.index.bytes == 0) continue;
      if (listed.index.bytes > bytes_.size()) throw_too_long();
      chunk_ += listed.index.bytes;
      with_values_.push_back(listed);
    }
  }

  std::size_t object_of(const std::string& path) {
    const auto [at, fresh] = known_.try_emplace(path, objects_.size());
    if (fresh) objects_.push_back({path, {}, false});
    return at->second;
  }

  void read_index(std::size_t object, const LeadIn& lead) {
    constexpr std::uint32_t none = 0xffffffff;
    constexpr std::uint32_t as_before = 0;
    const auto length = cursor_.number<std::uint32_t>();
    if (lead.has(of_daqmx) || length == 0x1269 || length == 0x1369) {
      throw_daqmx();
    }
    if (length == none) {
      put({object, {}});
    } else if (length == as_before) {
      put({object, indices_[object]});
    } else {
      indices_[object] = read_new_index();
      put({object, indices_[object]});
    }
  }

  RawIndex read_new_index() {
    const std::size_t at = cursor_.at();
    const auto code = cursor_.number<std::uint32_t>();
    const auto dimension = cursor_.number<std::uint32_t>();
    RawIndex index{.type = tdms_number_type(code),
                   .count = cursor_.number<std::uint64_t>()};
    index.width = index.type ? size_of(*index.type) : width_of_others(code);
    if (code == string_type) {
      index.bytes = cursor_.number<std::uint64_t>();
    } else if (index.width == 0 || dimension != 1) {
      throw InputError(
          fmt::format("holds values of a kind that is not read (0x{:x})", code),
          place(at),
          "save it with floating point numbers; if it has, it is damaged");
    } else if (index.count > bytes_.size() / index.width) {
      throw_too_long();
    } else {
      index.bytes = index.count * index.width;
    }
    return index;
  }

  [[noreturn]] void throw_daqmx() const {
    throw InputError(
        "holds raw values as the DAQmx driver writes them, which are not read",
        place(cursor_.at()),
        "save it in LabVIEW or DIAdem as TDMS with scaled values, or as CSV");
  }

  [[noreturn]] void throw_too_long() const {
    throw InputError("announces more values than the file holds",
                     place(cursor_.at()),
                     "copy the file again, or export it anew");
  }

  void put(const Listed& listed) {
    const auto at = places_.find(listed.object);
    if (at != places_.end() && at->second < list_.size() &&
        list_[at->second].object == listed.object) {
      list_[at->second] = listed;
      return;
    }
    // Each segment goes through them all.
    constexpr std::size_t most_channels = 10000;
    if (list_.size() == most_channels) {
      throw InputError(
          fmt::format("has more than {} channels", most_channels),
          place(cursor_.at()),
          "export fewer of them; if it has not that many, it is damaged");
    }
    places_[listed.object] = list_.size();
    list_.push_back(listed);
  }

  void read_property(TdmsObject& object) {
    const std::string name = as_utf8(cursor_.text());
    const auto code = cursor_.number<std::uint32_t>();
    if (code == string_type) {
      object.properties[name] = as_utf8(cursor_.text());
    } else if (const auto type = tdms_number_type(code)) {
      double value = 0.0;
      decode(cursor_.bytes(size_of(*type)).data(), 0, *type, order_, 1, &value);
      object.properties[name] = value;
    } else if (const std::size_t width = width_of_others(code); width > 0) {
      (void)cursor_.bytes(width);
    } else {
      throw InputError(
          fmt::format("property \"{}\" is of a kind that is not read (0x{:x})",
                      name,
                      code),
          place(cursor_.at()),
          "copy the file again, or export it anew");
    }
  }

  void read_raw_data(const LeadIn& lead) {
    if (lead.has(of_daqmx)) throw_daqmx();
    cursor_.go_to(lead.raw_begin);
    std::string_view raw = cursor_.bytes(lead.end - lead.raw_begin);
    while (!raw.empty() && chunk_ > 0) {
      const std::size_t step =
          static_cast<std::size_t>(std::min<std::uint64_t>(raw.size(), chunk_));
      if (lead.has(interleaved)) {
        read_interleaved(raw.substr(0, step));
      } else {
        read_chunk(raw.substr(0, step));
      }
      raw.remove_prefix(step);
    }
  }

  // The last chunk may be a part of one: each channel then has the same part.
  void read_chunk(std::string_view chunk) {
    std::size_t at = 0;
    for (const Listed& listed : with_values_) {
      const RawIndex& index = listed.index;
      std::uint64_t bytes = index.bytes;
      if (chunk.size() < chunk_ && index.width > 0) {
        const long double part = static_cast<long double>(chunk.size()) *
                                 static_cast<long double>(index.count) /
                                 static_cast<long double>(chunk_);
        bytes = index.width * static_cast<std::uint64_t>(part);
      }
      if (bytes > chunk.size() - at) return;
      give(listed, chunk.data() + at, index.width, bytes);
      at += static_cast<std::size_t>(bytes);
    }
  }

  void read_interleaved(std::string_view chunk) {
    std::size_t row = 0;
    for (const Listed& listed : with_values_) row += listed.index.width;
    if (row == 0) return;
    const std::size_t rows = chunk.size() / row;
    std::size_t at = 0;
    for (const Listed& listed : with_values_) {
      give(listed, chunk.data() + at, row, rows * listed.index.width);
      at += listed.index.width;
    }
  }

  void give(const Listed& listed,
            const char* bytes,
            std::size_t stride,
            std::uint64_t size) {
    const RawIndex& index = listed.index;
    if (!index.type || size < index.width) return;
    objects_[listed.object].has_numbers = true;
    take_({.object = listed.object,
           .bytes = bytes,
           .stride = stride,
           .type = *index.type,
           .order = order_,
           .count = static_cast<std::size_t>(size / index.width)});
  }

  [[nodiscard]] std::string place(std::size_t at) const {
    return fmt::format("{}, byte {}", file_.string(), at);
  }

  std::string_view bytes_;
  const std::filesystem::path& file_;
  const std::function<void(const TdmsPiece&)>& take_;
  ByteCursor cursor_;
  ByteOrder order_ = ByteOrder::Little;
  std::vector<TdmsObject> objects_;
  std::map<std::string, std::size_t> known_;   ///< objects by path
  std::map<std::size_t, RawIndex> indices_;    ///< last told, by object
  std::vector<Listed> list_;                   ///< of the present segment
  std::map<std::size_t, std::size_t> places_;  ///< in that list, by object
  std::vector<Listed> with_values_;
  std::uint64_t chunk_ = 0;  ///< bytes of a whole chunk
};

}  // namespace

std::vector<TdmsObject> read_tdms_segments(
    std::string_view bytes,
    const std::filesystem::path& file,
    const std::function<void(const TdmsPiece&)>& take) {
  return TdmsReader(bytes, file, take).read();
}

}  // namespace tapfit::acquisition
