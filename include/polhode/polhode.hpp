// SPDX-License-Identifier: MIT
// The whole public interface: run files, simulations and other jobs, and their components:
// molecules, forces, schemes and the free rotor. Link with polhode::library.
#pragma once

#include "polhode/ensemble/random_streams.hpp"
#include "polhode/forces/domain_forces.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/body_flows.hpp"
#include "polhode/integrate/force_program.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/run/adviser/adviser.hpp"
#include "polhode/run/analysis/analysis.hpp"
#include "polhode/run/canonical/canonical_study.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/properties/measure.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "polhode/run/simulation/system/single_point.hpp"
#include "polhode/run/study/study.hpp"
#include "polhode/run/study/tune.hpp"
#include "polhode/run/top/top.hpp"
