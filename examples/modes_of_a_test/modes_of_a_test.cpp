// Prints the modes of a test bundle: modes_of_a_test BUNDLE
#include "acquisition/foundation/input_error.hpp"
#include "updating/session/session.hpp"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: modes_of_a_test BUNDLE\n", stderr);
    return 2;
  }
  try {
    tapfit::updating::Session session(argv[1]);
    for (const tapfit::modal::Mode& mode : session.modes().modes) {
      std::printf("%10.4f Hz  %7.4f %%\n",
                  mode.frequency_hz,
                  100.0 * mode.damping_ratio);
    }
  } catch (const tapfit::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
