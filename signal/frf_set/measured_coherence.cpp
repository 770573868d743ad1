#include "signal/frf_set/measured_coherence.hpp"

namespace tapfit::signal {

bool has_coherence(const Frf& frf) {
  return frf.coherence.size() > 0 && frf.hits != 1 &&
         (frf.coherence.array() != 1.0).any();
}

}  // namespace tapfit::signal
