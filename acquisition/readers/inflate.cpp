#include "acquisition/readers/inflate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <zlib.h>

namespace tapfit::acquisition {

struct Inflate::State {
  std::istream& in;
  std::uintmax_t left = 0;
  z_stream stream = {};
  std::array<unsigned char, 1 << 14> input = {};
  bool good = false;
  bool ended = false;

  void refill() {
    const auto step = std::min<std::uintmax_t>(left, input.size());
    in.read(reinterpret_cast<char*>(input.data()),
            static_cast<std::streamsize>(step));
    left -= step;
    stream.next_in = input.data();
    stream.avail_in = static_cast<uInt>(in.gcount());
  }
};

Inflate::Inflate(std::istream& in, std::uintmax_t length, Wrapping wrapping)
    : state_(new State{.in = in, .left = length}) {
  const int bits = wrapping == Wrapping::Zlib ? MAX_WBITS : -MAX_WBITS;
  state_->good = inflateInit2(&state_->stream, bits) == Z_OK;
}

Inflate::~Inflate() { inflateEnd(&state_->stream); }

std::uintmax_t Inflate::unpack(unsigned char* to, std::uintmax_t count) {
  constexpr std::uintmax_t most = std::numeric_limits<uInt>::max();
  State& s = *state_;
  std::uintmax_t done = 0;
  while (s.good && !s.ended && done < count) {
    const std::uintmax_t step = std::min(count - done, most);
    s.stream.next_out = to + done;
    s.stream.avail_out = static_cast<uInt>(step);
    if (s.stream.avail_in == 0) s.refill();
    const int status = inflate(&s.stream, Z_NO_FLUSH);
    s.ended = status == Z_STREAM_END;
    s.good = s.ended || status == Z_OK;
    done += step - s.stream.avail_out;
  }
  return done;
}

bool Inflate::ended_well() const { return state_->good && state_->ended; }

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()),
            &size,
            reinterpret_cast<const Bytef*>(bytes.data()),
            static_cast<uLong>(bytes.size()),
            Z_BEST_SPEED);
  packed.resize(size);
  return packed;
}

std::uint32_t crc32_of(std::string_view bytes) {
  constexpr std::size_t piece = std::size_t{1} << 30U;
  uLong sum = crc32(0, nullptr, 0);
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    const std::string_view part = bytes.substr(at, piece);
    sum = crc32(sum,
                reinterpret_cast<const Bytef*>(part.data()),
                static_cast<uInt>(part.size()));
  }
  return static_cast<std::uint32_t>(sum);
}

std::string packing_library() { return zlibVersion(); }

}  // namespace tapfit::acquisition
