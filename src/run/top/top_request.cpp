// SPDX-License-Identifier: MIT
#include "run/top/top_request.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "polhode/run/top/top.hpp"

namespace polhode {
namespace {

Vec3<double> three_numbers(const Given& given) {
  const std::vector<double> x = given_numbers(given, 3, "\"1, 2, 3\"");
  return {x[0], x[1], x[2]};
}

}  // namespace

std::vector<RequestOption<TopRequest>> TopRequest::options() {
  using R = TopRequest;
  return {
      {"J", &R::J, "principal moments of inertia in any consistent units: \"1, 2, 3\""},
      {"L", &R::L, "body-frame angular momentum: \"0.1, 0.2, 1\""},
      {"step", &R::step, "time step; default: a rotation by 0.2 rad per step"},
      {"length", &R::length, "length of the trajectory; default: 200 steps"},
      {"output", &R::output,
       "prefix of a figure of the polhode on the inertia ellipsoid: PREFIX.svg, .png, .dat, .gp"},
      {"table", &R::table,
       "CSV file with the columns I1,I2,I3,L1,L2,L3,t and one top per row; prints the rotation of "
       "each top"},
      {"method", &R::method,
       fmt::format("method for the table: {}; default: {}",
                   fmt::join(enum_names<RotorMethod>, ", "), enum_names<RotorMethod>[0])}};
}

FreeTop TopRequest::top() const {
  FreeTop top;
  if (J) top.J = three_numbers(J);
  if (L) top.L = three_numbers(L);
  if (!J || !L)
    throw Error(fmt::format("a top needs three principal moments and three components of angular "
                            "momentum: write for example {} 1,2,3 {} 0.1,0.2,1, or give a {}",
                            J.name, L.name, table.name),
                J.name + ", " + L.name);
  if (step) top.step = given_numbers(step, 1, "0.1").front();
  if (length) top.length = given_numbers(length, 1, "20").front();
  return top;
}

std::string TopRequest::rotated_table() const {
  return rotate_table(table.text, method ? given_name<RotorMethod>(method) : RotorMethod::series);
}

}  // namespace polhode
