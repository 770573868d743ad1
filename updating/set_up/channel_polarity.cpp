#include "updating/set_up/channel_polarity.hpp"

#include <fmt/format.h>

namespace tapfit::effects {

std::vector<ParameterSpec> ChannelPolarity::parameters(const Where&,
                                                       const Setting&) const {
  return {};
}

std::complex<double> ChannelPolarity::law(std::complex<double>,
                                          const std::vector<double>&,
                                          std::size_t) const {
  return -1.0;
}

std::complex<double> ChannelPolarity::law_derivative(std::complex<double>,
                                                     const std::vector<double>&,
                                                     std::size_t,
                                                     std::size_t) const {
  return 0.0;
}

void ChannelPolarity::correct(const Where& where,
                              const acquisition::TestBundle&,
                              acquisition::TestBundle& sheet) const {
  for (acquisition::Channel& channel : sheet.channels) {
    const bool own = channel.name == where.channels.front();
    if (own) channel.sensitivity = -channel.sensitivity;
  }
}

std::vector<std::string> ChannelPolarity::bulk_data(
    const Where& where, const Setting&, const std::vector<double>&) const {
  return {
      fmt::format("$ Channel {} has the wrong sign; the model is not at "
                  "fault",
                  where.channels.front())};
}

}  // namespace tapfit::effects
