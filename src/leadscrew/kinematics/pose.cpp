#include <leadscrew/kinematics/pose.hpp>

namespace leadscrew::kinematics {

template Coordinates<double> machine_of(const Chain&, const Coordinates<double>&, const Vector&);
template Coordinates<double> pose_of(const Chain&, const Coordinates<double>&, const Vector&);
template Coordinates<numeric::Jet<>> machine_of(const Chain&, const Coordinates<numeric::Jet<>>&, const Vector&);
template Coordinates<numeric::Jet<3, numeric::Pair>> machine_of(const Chain&,
                                                                const Coordinates<numeric::Jet<3, numeric::Pair>>&,
                                                                const Vector&);
template Coordinates<numeric::Jet<>> pose_of(const Chain&, const Coordinates<numeric::Jet<>>&, const Vector&);

}  // namespace leadscrew::kinematics
