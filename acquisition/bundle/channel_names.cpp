#include "acquisition/bundle/channel_names.hpp"

namespace tapfit::acquisition {

std::vector<std::string> channel_names(const TestBundle& bundle) {
  std::vector<std::string> names;
  for (const Channel& channel : bundle.channels) names.push_back(channel.name);
  return names;
}

}  // namespace tapfit::acquisition
