#include "time/load_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// What happens within such a time is a jump.
double no_time_at(double t) { return 1e-8 * std::max(1.0, std::abs(t)); }

/// A little later than t, also where the time of the results, t - zero, is made of it.
double just_behind(double t, double zero) {
  return std::nextafter(t + std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(zero)), unbounded);
}

}  // namespace

LoadTimes::LoadTimes(const Case& c) : zero_(c.clock_zero()), dt_initial_(c.time.dt_initial) {
  for (const Load& load : c.loads) {
    add_points({load.start, load.start + load.ramp}, [](int) { return true; });
    add_profile(load.start, load.factor, zero_ + c.time.end);
    for (const Profile& path : load.path) add_profile(load.start, path, zero_ + c.time.end);
  }
  for (const Needle& needle : c.needles)
    for (const Profile& path : needle.path) add_profile(zero_, path, zero_ + c.time.end);
}

template <class Changes>
void LoadTimes::add_points(const std::vector<double>& points, const Changes& changes) {
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    int next = i;  // the last point at the same time, up to rounding
    bool jumps = false;
    while (next < last && points[next + 1] - points[i] < no_time_at(points[i])) jumps = changes(next++) || jumps;
    kinks_.push_back(points[i]);
    if (jumps) {
      jumps_.push_back({points[i], just_behind(points[next], zero_)});
    } else if (i > 0 && changes(i - 1)) {
      const double passed = points[i] - points[i - 1],
                   ahead = next == last ? unbounded : points[next + 1] - points[next];
      if (passed < dt_initial_ && 10 * passed < ahead) jumps_.push_back({points[i], just_behind(points[i], zero_)});
    }
    i = next;
  }
}

void LoadTimes::add_profile(double start, const Profile& profile, double end) {
  if (!profile.varies()) return;
  std::vector<double> points;
  for (const double t : profile.formula->kinks())
    if (zero_ + t > start) points.push_back(zero_ + t);
  const auto value = [&](int i) { return profile.at({0, 0, 0}, points[i] - zero_); };
  add_points(points, [&](int i) { return value(i) != value(i + 1); });
  if (!profile.formula->kinks().empty()) return;
  Expression e{profile.formula, start, zero_, 0, {}};
  constexpr int looks = 20000;
  end = std::max(end, start);
  double least = unbounded, most = -unbounded;
  for (int i = 0; i <= looks; ++i) {
    e.times.push_back(start + (end - start) * i / looks);
    least = std::min(least, e.at(e.times.back()));
    most = std::max(most, e.at(e.times.back()));
  }
  e.tolerance = std::max(0.003 * (most - least), 1.5e-4 * std::max(std::abs(least), std::abs(most)));
  expressions_.push_back(std::move(e));
}

/// Whether the value between t and t + dt lies on a line, at the times that are always tested and at some irregular
/// ones.
bool LoadTimes::Expression::follows_line(double t, double dt) const {
  const double from = at(t), to = at(t + dt);
  const auto near = [&](double s) { return std::abs(at(s) - from - (s - t) / dt * (to - from)) <= tolerance; };
  constexpr double golden = 0.6180339887498949;
  for (int k = 1; k <= 16; ++k)
    if (!near(t + dt * std::fmod(golden * k, 1.0))) return false;
  auto s = std::upper_bound(times.begin(), times.end(), t);
  for (; s != times.end() && *s < t + dt; ++s)
    if (!near(*s)) return false;
  return true;
}

/// Reach from t, or from the start of the load where that is later.
LoadTimes::Reach LoadTimes::Expression::reach(double t, double wish) const {
  const double begin = std::max(t, start), no_time = no_time_at(t);
  if (t + wish <= start || follows_line(begin, t + wish - begin)) return {wish, false};
  double bad = t + wish, good = 0.5 * (begin + bad);
  for (; good - begin > no_time && !follows_line(begin, good - begin); good = 0.5 * (begin + good)) bad = good;
  if (good - begin <= no_time && changes(begin, good)) {  // a jump that is all but there
    bad = good;
    good = begin;
  }
  constexpr int enough = 4;  // halvings, where the change is none that only its time ends
  for (int k = 0; bad - good > no_time && (k < enough || changes(good, bad)); ++k) {
    const double middle = 0.5 * (good + bad);
    (follows_line(begin, middle - begin) ? good : bad) = middle;
  }
  if (!changes(good, bad)) return {good - t, false};
  good = before_change(good, bad);
  return {t + (good - t) > good ? std::nextafter(good - t, 0.0) : good - t, true};
}

bool LoadTimes::Expression::changes(double from, double to) const { return std::abs(at(to) - at(from)) > tolerance; }

/// The last number at which the value is still that at `from`, though it is not at `to`.
double LoadTimes::Expression::before_change(double from, double to) const {
  double good = from;
  for (double middle = 0.5 * (good + to); good < middle && middle < to; middle = 0.5 * (good + to))
    (changes(from, middle) ? to : good) = middle;
  return good;
}

/// Where time goes on from t: behind what changes in no time there; else t.
double LoadTimes::Expression::behind(double t) const {
  const double from = std::max(t, start), far = t + 2 * no_time_at(t);
  if (far <= start || !changes(from, far)) return t;
  const double past = just_behind(std::nextafter(before_change(from, far), unbounded), zero);
  return past < far && !changes(past, far) ? past : far;
}

/// The distance of an oscillation from a line is large at its turning points and small between them. Steps that follow
/// its phase would add errors of one sign up, so the next ones of the same length must fit as well.
double LoadTimes::Expression::longest(double t, double wish) const {
  const Reach first = reach(t, wish);
  if (first.jump || t + first.dt <= start) return first.dt;
  constexpr int ahead = 3;
  double dt = first.dt;
  for (int k = 1; k <= ahead; ++k)
    if (const Reach next = reach(t + k * first.dt, dt); !next.jump) dt = std::min(dt, next.dt);
  return dt;
}

double LoadTimes::longest(double t, double wish) const {
  for (const Expression& e : expressions_) wish = std::min(wish, std::max(e.longest(t, wish), no_time_at(t)));
  return wish;
}

double LoadTimes::behind(double t) const {
  double last = t;
  for (const Jump& jump : jumps_)
    if (t < jump.behind && jump.time <= t + no_time_at(t)) last = std::max(last, jump.behind);
  for (const Expression& e : expressions_) last = std::max(last, e.behind(t));
  return last;
}

double LoadTimes::jump_at(double t) const { return behind(t) > t ? t : unbounded; }

}  // namespace softwet
