"""Random laws of joints: every law, with fracture energies that let a mesh of some hundred blocks resolve them."""


def softening(maker, kind):
    strength = maker.between(1, 5)
    law = {"type": kind, "tensile_strength": strength, "fracture_energy": maker.between(0.05, 0.3)}
    if maker.of(True, False):
        law |= {"cohesion": round(strength * maker.between(1, 2), 3), "friction_angle": maker.of(0, 20, 37, 45)}
    if maker.of(True, False, False):
        law |= {"shear_fracture_energy": round(law["fracture_energy"] * maker.between(1, 10), 4)}
    return law


def released(maker):
    strength = maker.between(1, 5)
    return {"type": "mohr_coulomb", "tensile_strength": strength, "cohesion": round(strength * maker.between(1, 2), 3),
            "friction_angle": maker.of(0, 20, 37)}


def weak_law(maker, treatment):
    """A law that cracks; one that releases at once is for joints without iterated or unknown multipliers."""
    kinds = ["linear_softening"] * 3 + ["bilinear_softening", "exponential_softening"]
    if treatment in ("consistent", "penalty"):
        kinds.append("mohr_coulomb")
    kind = maker.random.choice(kinds)
    return released(maker) if kind == "mohr_coulomb" else softening(maker, kind)


def joint(maker, treatment, dry=False):
    """What an entry of `interfaces` says beside its place: law, treatment, and sometimes a random field."""
    law = {"type": "friction", "friction_angle": maker.of(10, 20, 30, 40)} if dry else weak_law(maker, treatment)
    out = {"law": law, "treatment": treatment}
    if not dry and maker.random.random() < 0.2:
        out["field"] = {"coefficient_of_variation": maker.of(0.05, 0.1, 0.2), "correlation_length": round(maker.depth / 4, 1),
                        "seed": maker.random.randint(1, 1000)}
    return out
