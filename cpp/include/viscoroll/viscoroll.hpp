/// @file
/// @brief Everything that the library offers.
#pragma once

#include "viscoroll/cores.hpp"      // IWYU pragma: export
#include "viscoroll/cylinder.hpp"   // IWYU pragma: export
#include "viscoroll/errors.hpp"     // IWYU pragma: export
#include "viscoroll/influence.hpp"  // IWYU pragma: export
#include "viscoroll/materials.hpp"  // IWYU pragma: export
#include "viscoroll/modal.hpp"      // IWYU pragma: export
#include "viscoroll/observer.hpp"   // IWYU pragma: export
#include "viscoroll/plane.hpp"      // IWYU pragma: export
#include "viscoroll/solve.hpp"      // IWYU pragma: export
#include "viscoroll/sphere.hpp"     // IWYU pragma: export
