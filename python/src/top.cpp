// SPDX-License-Identifier: MIT
// Free rotation of arrays of tops, and of a single top.
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>

#include <optional>

#include "arrays.hpp"
#include "bind.hpp"
#include "job_options.hpp"
#include "polhode/run/top/top.hpp"
#include "run/requests.hpp"
#include "run/top/top_figure.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Rotates n tops over their times. Returns quaternions (n, 4), and the angular momenta after the
/// rotation (n, 3).
nb::tuple rotations(const Rows& J, const Rows& L, const Numbers& t, const std::string& method) {
  const auto chosen = given_name<RotorMethod>({method, "method"});
  const std::size_t n = t.shape(0);
  if (J.shape(0) != n || L.shape(0) != n || J.shape(1) != 3 || L.shape(1) != 3)
    throw Error("J and L must have the shape (n, 3), and t the shape (n)");
  std::vector<double> q(4 * n), after(3 * n);
  {
    const nb::gil_scoped_release released;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3<double> moments = row(J, i), momentum = row(L, i);
      check_top(moments, momentum, t.data()[i], "J", "top " + std::to_string(i));
      const FreeRotation r = free_rotation(moments, momentum, t.data()[i], chosen);
      q[4 * i] = r.rotation.w, q[4 * i + 1] = r.rotation.x;
      q[4 * i + 2] = r.rotation.y, q[4 * i + 3] = r.rotation.z;
      for (std::size_t k = 0; k < 3; ++k) after[3 * i + k] = r.L[k];
    }
  }
  return nb::make_tuple(array_of(std::move(q), {n, 4}), array_of(std::move(after), {n, 3}));
}

void add(std::vector<double>& row, const Quaternion<double>& q, const Vec3<double>& L) {
  row.insert(row.end(), {q.w, q.x, q.y, q.z, L.x, L.y, L.z});
}

/// Returns the samples of a TopTrajectory. The samples contain t, and the rotation and L by the
/// closed form, the series and NO_SQUISH. For the series and NO_SQUISH, the samples also contain
/// the relative errors of energy and momentum, and the angle.
nb::object top(const Options& given, const JobOptions& options) {
  const auto request = request_of<TopRequest>(given);
  const auto [J, L, step, length] = request.top();
  std::optional<TopFigure> figure;
  if (request.output) figure.emplace(request.output.text, options.output);
  const TopTrajectory trajectory = options.run(
      [&, J = J, L = L, step = step, length = length](const Callbacks& callbacks, Workers&) {
        TopTrajectory made = integrate_top(J, L, step, length, callbacks.stop);
        if (figure && !made.interrupted) draw_top(*figure, J, L, callbacks);
        return made;
      });
  std::vector<double> rows;
  for (const TopSample& s : trajectory.samples) {
    rows.push_back(s.t);
    add(rows, s.exact.rotation, s.exact.L);
    for (const TopTrack* track : {&s.series, &s.no_squish}) {
      add(rows, track->orientation, track->L);
      rows.insert(rows.end(), {track->energy_error, track->momentum_error, track->angle});
    }
  }
  const std::size_t n = trajectory.samples.size(), columns = n == 0 ? 0 : rows.size() / n;
  return array_of(std::move(rows), {n, columns});
}

}  // namespace

void bind_top(nb::module_& m) {
  m.def("rotations", &rotations);
  m.def("top", &top);
  m.def("rotate_table",
        [](const Options& given) { return request_of<TopRequest>(given).rotated_table(); });
}

}  // namespace polhode::python
