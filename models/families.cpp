#include "models/contact/contact_law.hpp"
#include "models/crack_direction/direction.hpp"
#include "models/gauge/gauge.hpp"
#include "models/interface/law.hpp"
#include "models/kinematics/kinematics.hpp"
#include "models/load/load.hpp"
#include "models/material/material.hpp"
#include "models/time_function/time_function.hpp"
#include "models/treatment/treatment.hpp"

namespace dda {

MaterialFamily& materials() {
  static MaterialFamily family("material", "What the inside of a block stores.");
  return family;
}

LawFamily& interface_laws() {
  static LawFamily family("law", "What an interface does with its opening.");
  return family;
}

KinematicsFamily& kinematics() {
  static KinematicsFamily family("kinematics", "How the displacement of a block varies within it.");
  return family;
}

TreatmentFamily& treatments() {
  static TreatmentFamily family("treatment", "How the two sides of an interface are joined.");
  return family;
}

ContactLawFamily& contact_laws() {
  static ContactLawFamily family("contact", "What bodies that meet in motion store where they touch.");
  return family;
}

TimeFunctionFamily& time_functions() {
  static TimeFunctionFamily family("time_function", "How something that is moved goes over time.");
  return family;
}

GaugeFamily& gauges() {
  static GaugeFamily family("gauge", "A scalar recorded at every step.");
  return family;
}

CrackDirectionFamily& crack_directions() {
  static CrackDirectionFamily family("direction", "Which way a crack through blocks goes on.");
  return family;
}

LoadFamily& loads() {
  static LoadFamily family("load", "What acts on the structure in a stage.");
  return family;
}

}  // namespace dda
