#include "acquisition/foundation/sha256.hpp"

#include <fmt/format.h>

#include <array>
#include <openssl/evp.h>
#include <stdexcept>

namespace tapfit::acquisition {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(),
                 bytes.size(),
                 digest.data(),
                 &size,
                 EVP_sha256(),
                 nullptr) != 1) {
    throw std::runtime_error("libcrypto has no SHA-256");
  }
  std::string text;
  for (unsigned int k = 0; k < size; ++k) {
    text += fmt::format("{:02x}", digest[k]);
  }
  return text;
}

}  // namespace tapfit::acquisition
