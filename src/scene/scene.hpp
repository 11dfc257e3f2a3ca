// A scene: what a case becomes on the mesh. The only place where physics and discretisation meet.
#pragma once

#include <functional>
#include <utility>

#include "case/precision.hpp"
#include "scene/balance.hpp"
#include "scene/coefficients.hpp"
#include "scene/equations.hpp"
#include "scene/forces.hpp"
#include "scene/regions.hpp"
#include "scene/terms.hpp"

namespace softwet {

/// Owns the objects of a scene, each of which is whole when it is made and takes those that it needs. What needs one
/// alone takes that one.
template <int D, int P>
class Scene {
 public:
  /// Errors: see Regions and Coefficients.
  explicit Scene(const Case& c)
      : regions_(c),
        coefficients_(regions_, c),
        forces_(regions_.layout(), c),
        terms_(regions_, coefficients_, c),
        equations_(regions_, forces_, terms_, precision_of(c)),
        balance_(regions_, coefficients_, forces_, terms_) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const Regions<D>& regions() const { return regions_; }
  const Coefficients<D>& coefficients() const { return coefficients_; }
  const Forces<D>& forces() const { return forces_; }
  const Terms<D, P>& terms() const { return terms_; }
  const Equations<D, P>& equations() const { return equations_; }
  const Balance<D, P>& balance() const { return balance_; }
  const Layout<D>& layout() const { return regions_.layout(); }
  ConstArray mask() const { return regions_.mask(); }

  /// See Equations::set_source.
  void set_source(std::function<void(double time, const Array& out)> source) {
    equations_.set_source(std::move(source));
  }

 private:
  Regions<D> regions_;
  Coefficients<D> coefficients_;
  Forces<D> forces_;
  Terms<D, P> terms_;
  Equations<D, P> equations_;
  Balance<D, P> balance_;
};

}  // namespace softwet
