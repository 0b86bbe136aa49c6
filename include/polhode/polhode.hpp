// SPDX-License-Identifier: MIT
// All that programs of your own need: run files, simulations and the other jobs, and beneath them
// molecules, forces, schemes and the free rotor. Link with polhode::library.
#pragma once

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/body_flows.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/simulation.hpp"
