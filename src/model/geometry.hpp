// How a Jacobian-vector product treats the map.
#pragma once

namespace softwet {

/// exact: the product differentiates the mesh (shape derivatives); frozen: the geometry is held (preconditioners).
enum class Geometry { exact, frozen };

}  // namespace softwet
