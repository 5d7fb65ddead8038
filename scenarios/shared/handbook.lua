-- Closed forms of fracture for scenes to compare with: local handbook = dem.include "handbook.lua" {}
--
-- Sources: Tada, Paris & Irwin, The Stress Analysis of Cracks Handbook, 3rd ed. (2000); Srawley, Int. J. Fracture 12 (1976)
-- 475, in ASTM E399; Erdogan & Sih, J. Basic Eng. 85 (1963) 519; Hondros, Aust. J. Appl. Sci. 10 (1959) 243; Kolsky, Stress
-- Waves in Solids (1953). docs/theory/references.md has the accuracy of each, tests/handbook.hpp the same in C++.
--
-- Shapes: K_I = stress * sqrt(pi a) * shape. Units are SI; shares are of the full width, below 1.
local pi, sqrt, sin, cos = math.pi, math.sqrt, math.sin, math.cos
local handbook = {}

-- ---- cracks across the load ----

-- One crack from an edge, ends free to turn; share = a / width, below 0.6: eq. 37 of Tavarez & Plesha (2007).
function handbook.edge_crack_polynomial(share)
  return 1.12 - 0.23 * share + 10.6 * share ^ 2 - 21.7 * share ^ 3 + 30.4 * share ^ 4
end

-- The same for every share.
function handbook.edge_crack(share)
  local turn = pi * share / 2
  return sqrt(math.tan(turn) / turn) * (0.752 + 2.02 * share + 0.37 * (1 - sin(turn)) ^ 3) / cos(turn)
end

-- A crack of length 2 a in the middle; share = 2 a / width.
function handbook.centre_crack(share) return (1 - 0.025 * share ^ 2 + 0.06 * share ^ 4) / sqrt(cos(pi * share / 2)) end

-- Cracks of length a from both edges; share = 2 a / width.
function handbook.double_edge_crack(share)
  local turn = pi * share / 2
  return (1 + 0.122 * cos(turn) ^ 4) * sqrt(math.tan(turn) / turn)
end

-- Three-point bend, span 4 W; share = a / W; the stress is 6 M / W^2 with M = P W.
function handbook.three_point_bend(share)
  local f = 1.5 * sqrt(share) * (1.99 - share * (1 - share) * (2.15 - 3.93 * share + 2.7 * share ^ 2))
    / ((1 + 2 * share) * (1 - share) ^ 1.5)
  return f / (1.5 * sqrt(pi * share))
end

-- The stress at which a crack of length a grows, its shape given.
function handbook.critical_stress(toughness, a, shape) return toughness / (shape * sqrt(pi * a)) end

-- The force per thickness at which a beam of depth W notched by a and bent over a span of 4 W fails.
function handbook.three_point_bend_force(toughness, a, width)
  return handbook.critical_stress(toughness, a, handbook.three_point_bend(a / width)) * width / 6
end

-- Length below which strength rules.
function handbook.transition_length(toughness, strength) return (toughness / strength) ^ 2 / pi end

-- ---- a crack of length 2 a in a wide plate, its normal turned by an angle (rad) from the load ----

-- K_I and K_II.
function handbook.slanted_crack(stress, a, angle)
  local whole = stress * sqrt(pi * a)
  return whole * cos(angle) ^ 2, whole * sin(angle) * cos(angle)
end

-- Direction, from the crack's own, of the highest hoop stress at its tip.
function handbook.kink_angle(opening, sliding)
  return -2 * math.atan(2 * sliding, opening + sqrt(opening ^ 2 + 8 * sliding ^ 2))
end

-- What K_I would give the same highest hoop stress.
function handbook.hoop_intensity(opening, sliding)
  local t = handbook.kink_angle(opening, sliding)
  return cos(t / 2) * (opening * cos(t / 2) ^ 2 - 1.5 * sliding * sin(t))
end

-- The stress at which a slanted crack kinks.
function handbook.slanted_critical_stress(toughness, a, angle)
  return toughness / handbook.hoop_intensity(handbook.slanted_crack(1, a, angle))
end

-- ---- a cohesive zone of constant traction (Dugdale) ----

-- The highest stress, over the strength, of a wide plate with a crack of length 2 a.
function handbook.plateau_wide_plate(a_over_transition)
  return 2 / pi * math.acos(math.exp(-pi ^ 2 / (8 * a_over_transition)))
end

-- ---- other bodies ----

-- Tension at the centre of a disc per force pressed radially on arcs of half_angle (rad; 0: lines).
function handbook.disc_tension(diameter, thickness, half_angle)
  local line = 2 / (pi * diameter * thickness)
  return half_angle > 0 and line * (sin(2 * half_angle) - half_angle) / sin(half_angle) or line
end

-- A compressive pulse meets a free end; impedance = density * wave speed. Thickness (m) and speed (m/s) of what flies off.
-- Of constant stress:
function handbook.spall_of_block(stress, length, impedance) return length / 2, 2 * stress / impedance end

-- With a sharp front that falls linearly to zero: the first piece.
function handbook.spall_of_ramp(stress, length, impedance, strength)
  return length / 2 * strength / stress, (2 * stress - strength) / impedance
end

return handbook
