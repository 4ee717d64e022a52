#include <Vdigital_integrator.h>
#include <Vstrict_integrator.h>
#include <gtest/gtest.h>

#include <leadscrew/pulse/integrator.hpp>

#include "clocked.hpp"

// rtl/paper/digital_integrator.sv beside pulse::Integrator.

namespace leadscrew::hardware {
namespace test_digital_integrator {

/// Three rounds of the remainder; `less`: what the model's remainder is above that of pulse::Integrator.
template <typename Model>
void expect_the_same_pulses(Clocked<Model>& model, int capacity, int integrand, int preload, int less) {
  model->capacity = static_cast<std::uint8_t>(capacity);
  model->integrand = static_cast<std::uint8_t>(integrand);
  model->preload = static_cast<std::uint8_t>(preload);
  model->load = 1;
  model->enable = 1;
  model.clock();
  model->load = 0;
  pulse::Integrator integrator(capacity, preload - less);
  for (int clock = 0; clock < 3 * capacity; ++clock) {
    model->eval();
    ASSERT_EQ(model->remainder, integrator.remainder() + less) << capacity << ' ' << integrand << ' ' << preload;
    ASSERT_EQ(model->overflow, integrator.add(integrand)) << capacity << ' ' << integrand << ' ' << preload;
    model.clock();
  }
}

TEST(DigitalIntegrator, OverflowsAsTheSoftwareDoes) {
  Clocked<Vdigital_integrator> model;
  for (int capacity = 1; capacity <= 64; ++capacity) {
    for (int integrand = 0; integrand <= capacity && integrand < 64; ++integrand) {
      expect_the_same_pulses(model, capacity, integrand, 0, 0);
      expect_the_same_pulses(model, capacity, integrand, capacity / 2, 0);
    }
  }
}

/// r > q: as one that begins one lower and overflows at r ≥ q.
TEST(DigitalIntegrator, ThatIsStrictOverflowsAboveItsCapacity) {
  Clocked<Vstrict_integrator> model;
  for (int capacity = 1; capacity <= 64; ++capacity) {
    for (int integrand = 0; integrand <= capacity && integrand < 64; ++integrand)
      expect_the_same_pulses(model, capacity, integrand, 0, 1);
  }
}

TEST(DigitalIntegrator, StandsStillWhereItIsNotEnabled) {
  Clocked<Vdigital_integrator> model;
  model->capacity = 5;
  model->integrand = 5;
  model->preload = 3;
  model->load = 1;
  model.clock();
  model->load = 0;
  model->enable = 0;
  for (int clock = 0; clock < 4; ++clock) {
    model->eval();
    EXPECT_EQ(model->overflow, 0);
    EXPECT_EQ(model->remainder, 3);
    model.clock();
  }
}

}  // namespace test_digital_integrator
}  // namespace leadscrew::hardware
