/// @file
/// @brief Numbers of the search for states of stick and slip, each with what it is for, or the case that chose it.
#pragma once

namespace viscoroll::detail {

/// @brief Of Newton steps at a given friction, and of how a state is reached by them. Residuals are those of all
/// conditions, as forces, per normal force.
///
/// "Tried" are 972 cases of the friction grid and 70 of the campaign with half and twice a number, or what is given:
/// none of them ended without a state.
struct FrictionSettings {
  // What a state is.

  /// Its residual, times the friction where that is less than 1; nor less than the tolerance of a contact ...
  double tolerance = 1e-10;
  /// ... and by no less a friction than this, for the load itself is known to 1e-14.
  double least_friction = 0.01;
  /// The same where steps no longer halve it. Not times the friction, it left nodes that stick with 2 % of the fastest
  /// slip at a friction of 0.0048.
  double round_off = 1e-8;
  /// Slip of nodes that stick, per spread of the strain: a fifth of what the campaign allows. On meshes of a million
  /// nodes the residual alone left them 1e-4 ...
  double largest_creep = 2e-7;
  /// ... before these steps.
  int steps_of_rest = 3;

  /// The residual of an instant of a motion, whose errors later ones inherit, and which direct solutions take to ...
  double instant_tolerance = 1e-12;
  /// ... or here, where steps no longer halve it.
  double instant_round_off = 1e-10;

  // When steps are in vain.

  /// Residual that steps do not come back from in time, relative to that of the start where the start has more than 1:
  /// a node that is carried by the whole lag of a spacing has forces far above a small load, and one step undoes them.
  double hopeless = 1e3;
  /// Steps of an iteration: two or three times what a state takes from full stick. With them only 4 of 10 000 that came
  /// to a state would not have, ...
  int steps = 25;
  /// ... which took up to so many, the residual halving ...
  int most_steps = 60;
  /// ... in so many of them. Tried: half costs 1 % in products, twice is the same.
  int halving = 12;
  /// Operations in products that a search may take, some seconds, ...
  double effort = 1e10;
  /// ... or eight times the products of most states ...
  double products = 800;
  /// ... within so many times that.
  double costly = 4.0;

  // How steps are taken.

  /// Those that may raise the residual while nodes find their sets. Tried: with half the longest way took 38 steps in
  /// place of 20, with twice 22; products are the same to 1 % ...
  int free_steps = 8;
  /// ... which they have nearly found on a coarser mesh.
  int free_steps_nearby = 3;
  /// Of the least residual, from which free steps are taken back. Without it 79 cases of the friction grid, all at 0.01
  /// and less, took 72 steps on average in place of 23.
  double astray = 2.0;
  /// Shorter steps lead out of no cycle of nodes either. Tried: 0.25 costs 30 % more products, 0.01 is the same.
  double shortest_step = 0.05;
  /// Beyond, what slides as a whole hardly changes, and steps lose themselves; where a drive is passed lies below.
  double most_creepage = 1.0;
  /// Residual of a step by products, what its change of sets is worth; a tenth of it after the free ones. Tried: 1e-3
  /// to 0.1 within 6 % of the products. All steps careful, up to 300 nodes in contact, were a fifth fewer and cost a
  /// fifth to a third more products, in 657 cases of the campaign and 972 of the grid, each with a state.
  double rough_step = 1e-2;
  /// Of a careful step: from 10 coarser meshes from which rough ones did not lead, these did 8 times.
  double exact_step = 1e-6;

  // How a state is reached.

  /// Traction per its limit from which a node slips as in the instant before: carried between two rows it has less.
  double likely_slip = 0.97;

  /// Towards full stick, as a start: further ones move nodes with tension back and forth. Tried: half costs 5 % less,
  /// twice a tenth to a quarter more.
  int steps_of_full_stick = 6;
  /// Steps from a coarser mesh that must have halved the residual ...
  int patience_nearby = 8;
  /// ... and those from between two creepages, before the range is halved. Tried: all the same, for both end what
  /// fails.
  int patience_between = 14;
  /// From which a given creepage was found at a friction of 4 where nothing else led to it.
  double easy_friction = 0.3;
  /// Share of the way from there, on which strides are halved, that is too short to go on: a seventh halving. Tried:
  /// 0.1 is the same.
  double shortest_stride = 0.01;
  /// Below which the scale of creepages is linear.
  double small_creepage = 1e-5;
  /// Of the range of creepages, to a millionth.
  int halvings = 20;
};

inline constexpr FrictionSettings kFrictionSettings{};

}  // namespace viscoroll::detail
