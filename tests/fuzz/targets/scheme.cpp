// SPDX-License-Identifier: MIT
#include "../fuzz.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

// A scheme has no place of its own: its reader gives the key or the option.
void polhode::fuzz::read(std::string_view text) try {
  const NestedScheme scheme = nested_scheme_of(text);
  nested_scheme_of(named_text_of(scheme));
} catch (const Error& e) {
  throw e.at("fuzz.toml:1, integrator.scheme");
}
