// SPDX-License-Identifier: MIT
#include "base/printable.hpp"

#include "../errors.hpp"

using namespace polhode;

TEST_CASE("control characters of terminals are escaped, all others are unchanged") {
  CHECK(printable("") == "");
  CHECK(printable("a b~`$(c)'\"\\ µ Å ω 水 𝛼") == "a b~`$(c)'\"\\ µ Å ω 水 𝛼");
  CHECK(printable("a\nb\tc\x1b[31m\x7f") == "a\\x0ab\\x09c\\x1b[31m\\x7f");
  CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(printable("\u009b1m\u0080\u00a0") == "\\xc2\\x9b1m\\xc2\\x80\u00a0");
}

TEST_CASE("bytes that are not UTF-8 are escaped (RFC 3629)") {
  CHECK(printable("a\xff") == "a\\xff");
  CHECK(printable("\x9b[m") == "\\x9b[m");
  CHECK(printable("\xc3") == "\\xc3");
  CHECK(printable("\xc3(") == "\\xc3(");
  CHECK(printable("\xe6\xb0") == "\\xe6\\xb0");
  CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");                    // too long for '/'
  CHECK(printable("\xe0\x80\xaf") == "\\xe0\\x80\\xaf");           // likewise
  CHECK(printable("\xf0\x80\x80\xaf") == "\\xf0\\x80\\x80\\xaf");  // likewise
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // a surrogate
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  CHECK(printable("\xf4\x8f\xbf\xbf") == "\xf4\x8f\xbf\xbf");      // U+10FFFF
}

TEST_CASE("names with such bytes are refused") {
  check_name("the output", "water `ω` 1");
  check_error([] { check_name("the output", "a\nb"); },
              {"the output", "'a\\x0ab'", "0x0a", "name"});
  check_error([] { check_name("the output", "caf\xe9"); }, {"'caf\\xe9'", "0xe9", "UTF-8"});
}
