#include "acquisition/readers/audio_file.hpp"
#include "tests/fuzz/fuzz_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return tapfit::fuzz::read_as("run.wav", data, size, [](const auto& file) {
    (void)tapfit::acquisition::read_audio(file);
  });
}
