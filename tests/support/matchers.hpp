// What tests say of texts and of errors, in googlemock's words.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace tapfit {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Property;
using ::testing::Throws;

/// For EXPECT_THAT([&] { work(); }, Refuses("part")): it throws an InputError
/// that says so, place and remedy included.
inline auto Refuses(const std::string& part) {
  return ::testing::ThrowsMessage<InputError>(HasSubstr(part));
}

/// What an InputError says that some work throws; empty where it throws none.
template <typename Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace tapfit
