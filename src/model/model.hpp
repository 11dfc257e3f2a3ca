// The discrete equations of a scene: a list of terms on regions, sides, and loads. The only place where physics and
// discretisation meet.
#pragma once

#include <array>
#include <functional>
#include <variant>

#include "case/case.hpp"
#include "case/precision.hpp"
#include "field/ghosts.hpp"
#include "kernels/fluid/line_friction.hpp"
#include "kernels/functional/fluid_integrals.hpp"
#include "kernels/functional/solid_integrals.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/fibres.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/prestretch.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "model/integrals.hpp"
#include "model/loads.hpp"
#include "model/needles.hpp"
#include "model/pieces.hpp"

namespace softwet {

/// Mass and volume of the fluid, as the moments of the density have them: in the coordinates (r, z) those for each radian.
struct Filling {
  double mass = 0, volume = 0;
};
/// Volumes of the fluid's mesh and of the solid that are turned inside out.
struct MeshFaults {
  double folded = 0, inverted = 0;
};

/// What a solid has beside its elasticity, for bounds of explicit steps: 4/3 eta + zeta, the largest tension of its top face, the modulus
/// lambda_s + 2 G_s of this face, the stiffer springs and the stronger dashpots of its foundation, the largest stiffness of needles, and what
/// its branches add to the stiffness against fast waves.
struct SolidRates {
  double viscosity = 0, tension = 0, modulus = 0, foundation = 0, dashpots = 0, held = 0, branches = 0;
};

using Solid = std::variant<Elastodynamics<SaintVenantKirchhoff>, Elastodynamics<Hooke>, Elastodynamics<NeoHookean>>;

template <int D, int P>
class Model {
 public:
  explicit Model(const Case&);

  const Layout<D>& layout() const { return layout_; }
  const Coexistence& state() const { return coexistence_; }
  const NavierStokesKorteweg& fluid() const { return fluid_; }
  const Solid& solid() const { return solid_; }  ///< where the stiffness varies in space, where it is largest
  const SolidRates& rates_of_solid() const { return solid_rates_; }
  const LameParameters& stiffness() const { return stiffness_; }  ///< the same
  const Fibres& fibres() const { return fibres_; }                ///< of stiffness 0 where there are none
  const Branches& branches() const { return branches_; }          ///< none, or those of a viscoelastic solid
  const Prestretch& prestretch() const { return prestretch_; }    ///< of the material; that of fibres is part of them
  /// First Piola-Kirchhoff stress of the material, as stiff as it is at the point x of the undeformed solid, and of its
  /// fibres, with the prestretch; without its viscosity and its branches. On the host. In 2D Grad u has the third axis too.
  Matrix<double, 3> first_piola(const Matrix<double, 3>& grad_u, const std::array<double, 3>& x) const;
  /// Also of the gradient law: its capillarity and cosine. Where there is a field `painted` the cosine is 1.
  const EnergyWall& wall() const { return wall_.law; }
  /// The wall energy of the cosine 1.
  WallEnergy wall_of_one() const;
  const LineFriction& line_friction() const { return line_friction_; }  ///< only where Layout::rate_rows > 0
  /// Stiffness over that of `solid`, below and above a joint; empty where the solid has a kernel of its own (grade_solid).
  const GivenField<double>& graded(int part) const { return graded_[part]; }
  /// Cosine of the contact angle; empty where it does not vary and the wall has no exponent.
  const GivenField<double>& painted() const { return painted_; }
  double wall_stretch_exponent() const { return wall_stretch_exponent_; }
  /// Tension that the fluid gives the wall over the wall energy of the cosine 1; empty where it gives none.
  const GivenField<double>& wall_tension() const { return tension_; }
  const Pieces<D, double>& pieces() const { return pieces_; }
  const Pieces<D, float>& single_pieces() const { return single_; }
  Precision precision() const { return precision_; }
  int points() const { return points_; }  ///< Gauss points per element and axis
  const std::vector<LoadVector<D>>& loads() const { return loads_; }
  const Needles<D>& needles() const { return needles_; }
  ConstArray mask() const { return mask_; }  ///< 1 free, 0 prescribed or ghost
  double wall_height() const { return blend_.low; }
  /// What integrals of the equations have to be multiplied by for those of the whole scene: in the coordinates (r, z) they are
  /// those for each radian.
  double turn() const { return layout_.axisymmetric ? 2 * M_PI : 1; }
  bool has_wall() const { return has_wall_; }
  const Region<D>& fluid_region() const { return fluid_region_; }
  const Region<D>& solid_region() const { return solid_region_; }
  /// Rows of elements [first, last) over the whole width, with Gauss points or another rule per element and axis.
  Region<D> region(int first, int last, int points, const RuleMakers& = gauss_rules) const;
  /// Where a term is integrated, with those of the scene or others.
  Region<D> region(Where, int points) const;
  /// The same in parts: the solid below and above its joint, where it has one.
  std::vector<Region<D>> regions(Where, int points) const;
  const Blend& blend() const { return blend_; }

  /// Adds a source to the discrete equations: residual() calls source(t_{n+af}, out), which subtracts its load vector.
  /// For manufactured solutions (tests/verification/mms); production never sets it.
  void set_source(std::function<void(double time, const Array& out)> source) { source_ = std::move(source); }

  /// out = R(stage), zero where a value is prescribed.
  void residual(const Stage&, const Array& out) const;
  /// The terms of the fluid alone, before prescribed values are dropped, with the wall traction also on a rigid wall.
  /// The rows of the wall hold minus the force of the fluid on the wall.
  void fluid_residual(const Stage&, const Array& out) const;
  // Parts of a residual that are added to `out` and to the sums of a device, before ghosts are summed.
  /// The rows of the potential equation without (q, mu), so that M mu = -out. Other rows mean nothing.
  void add_potential(const Stage&, TileSums<D, double>&, const Array& out) const;
  /// The solid without its viscosity, the forces of the fluid on the wall, loads and the source. The acceleration of the stage counts as
  /// it is.
  void add_forces_of_solid(const Stage&, TileSums<D, double>&, const Array& out) const;
  /// The viscosity of the solid and the dashpots below it, where it has some. They are linear in the velocities of the stage.
  void add_viscosity_of_solid(const Stage&, TileSums<D, double>&, const Array& out) const;
  bool has_viscous_solid() const { return pieces_.first_viscous < pieces_.first_of_fluid; }
  /// out = dR/d(unknown) direction, exact with the mesh moving along or with the geometry frozen. The direction is zero where
  /// values are prescribed. Its ghosts, where there are some, are filled for the product and then set to zero again.
  /// @param unbalanced  where it is given, with what LineFrictionBend adds: of the rows of the potential, for each area of the wall
  void product(const Stage&, const Array& direction, const Array& out, Geometry,
               const ConstArray& unbalanced = {}) const;

  // The same in single precision.
  void residual(const StageOf<float>&, const ArrayOf<float>& work, const Array& out) const;
  void product(const StageOf<float>&, const ArrayOf<float>& direction, const ArrayOf<float>& out, Geometry,
               const ConstArrayOf<float>& unbalanced = {}) const;

  /// values = dR/d(unknown) with the geometry frozen, and always with the traction of one layer. Prescribed values count
  /// as free here, and rows of ghosts are empty.
  void jacobian(const StageOf<float>&, const StencilValues& values) const;

  Integrals integrals(const Stage&) const;
  Filling filling(const Stage&) const;
  MeshFaults faults(const Stage&) const;
  /// Power of the loads on a velocity field at a time.
  double load_power(double time, const ConstArray& unknown) const;
  /// What each needle measures of a state, of the whole scene.
  std::vector<NeedleReading> needle_readings(const Stage&) const;

 private:
  void build_axes(const Case&);
  void build_fluid(const Case&);
  void build_wall(const Case&);
  void build_solid(const Case&);
  void grade_solid(const Profile& young);
  void build_mask(const Case&);
  /// The same values on all rows that live on the wall.
  GivenField<double> on_wall(const std::vector<double>& of_row) const;
  template <class Real>
  void run_product(const Pieces<D, Real>&, const StageOf<Real>&, const ArrayOf<Real>& direction,
                   const ArrayOf<Real>& out, Geometry, const ConstArrayOf<Real>& unbalanced) const;
  /// What follows the terms in a residual: loads, needles, the source, ghosts, and prescribed values.
  template <class Real>
  void finish_residual(const StageOf<Real>&, const Array& out) const;
  template <class Real>
  Pieces<D, Real> pieces_of(const Case&) const;
  template <class Motion>
  void fluid_integrals(const Evaluation<D>&, Integrals&) const;
  template <class Motion, class Functional>
  void wall_integrals(const Functional&, Evaluation<D>, Integrals&) const;
  void solid_integrals(const Evaluation<D>&, Integrals&) const;
  void branch_integrals(const Stage&, Integrals&) const;
  std::array<double, FluidContents::count> fluid_contents(const Stage&) const;
  void add_loads(double time, const Array& out) const;

  Layout<D> layout_;
  Region<D> solid_region_, fluid_region_, wall_region_;
  Blend blend_;
  Coexistence coexistence_;
  NavierStokesKorteweg fluid_;
  WallEnergy wall_;
  LineFriction line_friction_;
  Solid solid_;
  LameParameters stiffness_;
  SolidRates solid_rates_;
  Fibres fibres_;
  Branches branches_;
  Prestretch prestretch_;
  Profile young_;
  double largest_young_ = 0, wall_stretch_exponent_ = 0;
  GivenField<double> graded_[2], painted_, tension_;
  bool has_wall_ = false, has_gravity_ = false, wall_feeds_ = false;
  Precision precision_;
  int points_;
  Pieces<D, double> pieces_;
  Pieces<D, float> single_;
  std::vector<LoadVector<D>> loads_;
  Needles<D> needles_;
  SolidGravity gravity_;
  std::function<void(double, const Array&)> source_;
  Array mask_;
};

}  // namespace softwet
