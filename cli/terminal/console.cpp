// SPDX-License-Identifier: MIT
#include "console.hpp"

#include <memory>
#include <string>

#include "interrupt.hpp"
#include "progress_line.hpp"
#include "streams.hpp"

namespace polhode::cli {

Callbacks console() {
  catch_interrupts();
  const auto line = std::make_shared<ProgressLine>();
  return {.progress = [line](const Progress& now) { line->show(now); },
          .stop = interrupted,
          .message =
              [line](const std::string& text) {
                line->clear();
                log("{}\n", text);
              }};
}

}  // namespace polhode::cli
