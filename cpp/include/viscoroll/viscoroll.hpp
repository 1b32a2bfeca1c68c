/// @file
/// @brief Includes all public headers of the library.
///
/// "The paper" in these headers is Zéhil & Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings".
/// Numbers of equations and sections are those of the paper; docs/theory describes its misprints.
#pragma once

#include "viscoroll/adhesion.hpp"            // IWYU pragma: export
#include "viscoroll/cores.hpp"               // IWYU pragma: export
#include "viscoroll/cylinder.hpp"            // IWYU pragma: export
#include "viscoroll/drive.hpp"               // IWYU pragma: export
#include "viscoroll/errors.hpp"              // IWYU pragma: export
#include "viscoroll/fields.hpp"              // IWYU pragma: export
#include "viscoroll/formulation.hpp"         // IWYU pragma: export
#include "viscoroll/influence.hpp"           // IWYU pragma: export
#include "viscoroll/interior.hpp"            // IWYU pragma: export
#include "viscoroll/load_case.hpp"           // IWYU pragma: export
#include "viscoroll/materials.hpp"           // IWYU pragma: export
#include "viscoroll/mesh.hpp"                // IWYU pragma: export
#include "viscoroll/modal.hpp"               // IWYU pragma: export
#include "viscoroll/modulus_functions.hpp"   // IWYU pragma: export
#include "viscoroll/modulus_types.hpp"       // IWYU pragma: export
#include "viscoroll/observer.hpp"            // IWYU pragma: export
#include "viscoroll/options.hpp"             // IWYU pragma: export
#include "viscoroll/plane.hpp"               // IWYU pragma: export
#include "viscoroll/profile.hpp"             // IWYU pragma: export
#include "viscoroll/result.hpp"              // IWYU pragma: export
#include "viscoroll/rolling_body.hpp"        // IWYU pragma: export
#include "viscoroll/rolling_history.hpp"     // IWYU pragma: export
#include "viscoroll/rolling_resistance.hpp"  // IWYU pragma: export
#include "viscoroll/sliding.hpp"             // IWYU pragma: export
#include "viscoroll/sliding_interior.hpp"    // IWYU pragma: export
#include "viscoroll/slow_terms.hpp"          // IWYU pragma: export
#include "viscoroll/solve.hpp"               // IWYU pragma: export
#include "viscoroll/sphere.hpp"              // IWYU pragma: export
#include "viscoroll/version.hpp"             // IWYU pragma: export
#include "viscoroll/wheel.hpp"               // IWYU pragma: export
