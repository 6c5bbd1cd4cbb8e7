"""Checks of the stored steps: equilibrium, laws, contact, damage, supports, size of displacements, stored energy."""
import numpy as np

from .finding import not_made, worst_of
from .laws import OfPlugin

EQUILIBRIUM = 1e-6  # of the forces on a block and a hundredth of those on the most loaded one of the run
CANCELLED = 1e-9    # of the largest force of initial stress on a block: what may be left where strain takes the stress away
ENVELOPE = 1e-4     # of the limit
LAW = 1e-4          # of the traction and a hundredth of the largest of the interface
ROUNDED = 1e-9      # of the largest traction of the run: what unloading may leave by rounding
REACTIONS = 1e-6    # of the largest sum of all loads and reactions and the force of initial stress on a block of the run
MULTIPLIERS = 1e-6  # of the shortening of a block under the largest traction
DAMAGE = 1e-9
ENERGY = 1e-6       # of the largest stored energy
DISPLACEMENT = 1.0  # of the diagonal of the structure
CURVE = 1e-9        # curve.csv against the fields, of the largest value of the column; reactions also of FORCE times those on a block
FORCE = 1e-3


def at(step, place, what):
    return f"step {step.number}, {what} at ({place[0]:.6g}, {place[1]:.6g})"


def worst_point(step, values, what):
    """(largest value, its place) over points; unknown tractions left out."""
    known = ~np.isnan(step.traction).any(axis=1) | np.isnan(values)
    values = np.where(known, values, 0)
    index = int(np.argmax(np.where(np.isnan(values), np.inf, values)))
    return values[index], at(step, step.model.points.place[index], what)


def residuals(step):
    """(residual force of every block and jump, sum of the forces on it); nan where a traction is not stored."""
    sizes = [np.sqrt(step.model.mesh.areas), step.model.gradients.sizes, np.ones(len(step.model.jumps))]
    size = np.concatenate(sizes)
    unit = np.stack([np.ones_like(size), np.ones_like(size), size, size, size, size], -1)
    unit[len(sizes[0]):len(sizes[0]) + len(sizes[1]), :2] = sizes[1][:, None]  # a gradient's unknowns are all strains
    residual, scale = np.zeros((len(size), 6)), np.zeros(len(size))
    for blocks, forces in step.parts():
        np.add.at(residual, blocks, forces)
        np.add.at(scale, blocks, np.abs(forces / unit[blocks]).max(axis=1))
    noise = np.zeros(len(size))
    for side in (0, 1):  # tractions of bonds are worked out from displacements
        of_bonds = np.where(step.model.points.active, 0, step.model.points.weight * step.noise)
        np.add.at(noise, step.model.points.blocks[:, side], of_bonds)
    for point, node, *_ in (step.model.points.gradients, step.model.points.jumps):
        np.add.at(noise, node, np.where(step.model.points.active, 0, step.model.points.weight * step.noise)[point])
    np.add.at(noise, step.model.springs["block"], step.spring_noise)
    noise += CANCELLED * force_of_initial_stress(step, sizes[0])
    return np.maximum(np.abs(residual / unit).max(axis=1) - noise, 0), scale


def force_of_initial_stress(step, sizes):
    """The largest on a block [F]; that of strain is as large against it where the block may move freely."""
    stress = np.abs(step.model.initial_stress(step.load_factors)).max(axis=1, initial=0)
    return (step.model.volumes * stress / sizes).max(initial=0)


def over(error, scale):
    """error / scale, zero where there is no error."""
    return np.where(error > 0, error / np.where(scale > 0, scale, 1e-300), error)


def equilibrium(steps, forces):
    """`forces` are the `residuals` of each step."""
    found, unknown = [], 0
    largest = 0.01 * max(np.nanmax(scale, initial=0.0) for _, scale in forces)
    for step, (residual, scale) in zip(steps, forces):
        error = over(residual, scale + largest)
        known = ~np.isnan(step.traction).any(axis=1)
        bad = np.zeros(len(error), dtype=bool)
        bad[step.model.points.blocks[~known].ravel()] = True
        unknown, error = int(bad.sum()), np.where(bad, 0, error)
        node = int(np.argmax(np.where(np.isnan(error), np.inf, error)))
        note = f" ({unknown} blocks have bonds by multipliers, which are not stored)" if unknown else ""
        found.append((error[node], at(step, *place_of(step, node)) + note))
    return worst_of("block equilibrium", found, EQUILIBRIUM)


def place_of(step, node):
    """Where a node is, and what."""
    beyond = node - step.model.num_block_nodes
    if beyond < 0:
        block = node if node < step.model.mesh.num_blocks else step.model.gradients.blocks[node - step.model.mesh.num_blocks]
        return step.model.centroids[block], f"block {block}"
    return step.model.jumps.middle[beyond], f"the part beyond the cut through block {step.model.jumps.block[beyond]}"


def per_interface(steps, value):
    """(largest value, place) of every interface and step; `value` gives one number per point."""
    for step in steps:
        for number, interface in enumerate(step.model.interfaces):
            chosen = step.points_of(number) & step.model.points.active
            if not chosen.any():
                continue
            values = np.zeros(len(step.traction))
            values[chosen] = value(step, interface, chosen)
            yield worst_point(step, values, interface.name or "a bond")


def of_plugins(steps):
    """What keeps laws from being checked: those that come from plugins; "" when there are none."""
    names = {interface.law.name for step in steps for interface in step.model.interfaces if isinstance(interface.law, OfPlugin)}
    return f"the law {', '.join(sorted(names))} is a plugin's" if names else ""


def envelope(steps):
    if unknown := of_plugins(steps):
        return not_made("law envelope", unknown)

    def value(step, interface, chosen):
        t = step.borne[chosen]
        excess, limit = interface.law.excess(t, step.law_state(chosen, interface))
        floor = 0.01 * np.abs(t).max(initial=0.0)
        return over(np.maximum(excess - step.noise[chosen], 0), limit + floor)
    return worst_of("law envelope", per_interface(steps, value), ENVELOPE)


def normal_law(steps):
    """t_n = k q_n where closed, r q_n where open: neither tension beyond the damage nor penetration."""
    if unknown := of_plugins(steps):
        return not_made("contact and normal law", unknown)

    least = ROUNDED * max((np.abs(step.borne).max(initial=0.0) for step in steps), default=0.0)

    def value(step, interface, chosen):
        t, q = step.borne[chosen, 0], step.seen[chosen, 0]
        error = interface.law.normal_error(t, q, step.law_state(chosen, interface)) - step.noise[chosen] - least
        scale = np.abs(t) + 0.01 * np.abs(step.borne[chosen]).max(initial=0.0)
        return over(np.maximum(error, 0), scale)
    return worst_of("contact and normal law", per_interface(steps, value), LAW)


def multipliers_settled(steps):
    """Iterated multipliers carry what the law gives: P m = t."""
    name = "multipliers carry the traction"
    if not any((step.model.points.kind == "augmented_lagrangian").any() for step in steps):
        return not_made(name, "no joint iterates them")
    found = []
    for step in steps:
        unit = np.nanmax(np.abs(step.traction).max(axis=1) / step.model.points.spring_unit)
        gap = np.maximum(np.abs(step.gap).max(axis=1) - 2 * step.noise / step.model.points.trial.min(axis=1), 0)
        found.append(worst_point(step, over(gap, unit), "a joint"))
    return worst_of(name, found, MULTIPLIERS)


def damage_before(before, now):
    """Damage of the points of a step one step before; what was not there had none."""
    def keys(step):
        points = step.model.points
        rows = np.column_stack([points.place, points.normal, points.blocks])
        return [tuple(row) for row in rows]
    if before.model is now.model:
        return before.damage
    known = dict(zip(keys(before), before.damage))
    return np.array([known.get(key, 0.0) for key in keys(now)])


def damage_grows(steps):
    found = []
    for before, now in zip(steps, steps[1:]):
        fall = damage_before(before, now) - now.damage
        found.append(worst_point(now, fall, "damage") if len(fall) else (0.0, "everywhere"))
    return worst_of("damage never falls", found, DAMAGE)


def resultant(step, blocks, forces):
    """(Fx, Fy, M/size) about the middle of the structure."""
    middle = step.model.mesh.vertices.mean(axis=0)
    lever = step.model.centroids[blocks] - middle
    moment = forces[:, 2] + lever[:, 0] * forces[:, 1] - lever[:, 1] * forces[:, 0]
    return np.array([forces[:, 0].sum(), forces[:, 1].sum(), moment.sum() / step.model.size])


def reactions_carry(steps):
    """Loads, reactions and what planes of symmetry bear sum up to nothing; what is left hangs in the weak springs.

    Strain that nothing hinders moves blocks without a reaction: weak springs bear a share of the forces of its initial stress.
    """
    found, largest = [], 0.0
    for step in steps:
        springs, every = step.model.springs, np.arange(step.model.mesh.num_blocks)
        of_blocks = springs["block"] < len(every)
        held = (springs["row"] * step.spring_forces[springs["spring"], None])[of_blocks]
        loads = step.model.forces(step.load_factors)[:len(every)]
        planes, borne = step.forces_on_planes
        rest = resultant(step, springs["block"][of_blocks], held) + resultant(step, planes, borne) + resultant(step, every, loads)
        of_stress = force_of_initial_stress(step, np.sqrt(step.model.mesh.areas))
        largest = max(largest, np.abs(held[:, :2]).sum() + np.abs(loads[:, :2]).sum() + of_stress)
        found.append((max(np.abs(rest).max() - step.spring_noise.sum(), 0.0), f"step {step.number}"))
    found = [(float(over(np.array(rest), largest)), place) for rest, place in found]
    return worst_of("reactions carry the load", found, REACTIONS)


def displacements(steps):
    found = []
    for step in steps:
        moved = np.hypot(step.d[:, 0], step.d[:, 1]) / step.model.size
        node = int(np.argmax(np.where(np.isnan(moved), np.inf, moved)))
        found.append((moved[node], at(step, *place_of(step, node))))
    return worst_of("displacements within the structure's size", found, DISPLACEMENT)


def stored_energy(step):
    """Of blocks, joints and supports; loads and what drives the structure have none."""
    model, points = step.model, step.model.points
    total = 0.5 * (model.volumes * np.einsum("bi,bi->b", step.strain, step.stress)).sum()
    g = step.d[model.mesh.num_blocks:model.num_block_nodes]
    total += 0.5 * np.einsum("bi,bij,bj->", g, model.gradients.stiffness, g)
    springs = model.springs
    held = np.all([springs[name] == 0 for name in ("dead", *model.references)], axis=0)
    held[step.gone[:, 0]] = False
    total += 0.5 * (step.spring_forces[held]**2 / springs["stiffness"][held]).sum()
    joints = np.zeros(len(points.weight))
    for number, interface in enumerate(model.interfaces):
        chosen = step.points_of(number)
        if chosen.any():
            joints[chosen] = interface.law.stored(step.borne[chosen], step.seen[chosen], step.law_state(chosen, interface))
    joints += step.water * (0.5 * step.water - step.borne[:, 0]) / points.trial[:, 0]  # the joint's spring holds the traction
    taken = 0.5 * (step.mean**2 / points.trial).sum(axis=1)
    taken += 0.5 * ((1 + points.perturbation[:, None]) * points.trial * step.multiplier**2).sum(axis=1)
    return total + (points.weight * (joints - taken)).sum()


def stored_energies(steps, curve):
    name = "stored energy of curve.csv"
    if any(np.any(part) for part in (*steps[0].model.stress, *steps[0].model.stress_gradients)):
        return not_made(name, "there is initial stress, whose energy is counted with the loads")
    if unknown := of_plugins(steps):
        return not_made(name, unknown)
    if any(np.isnan(step.traction).any() for step in steps):
        return not_made(name, "bonds by multipliers are not stored")
    scale = max(np.abs(curve["stored_energy"]).max(), np.abs(curve["external_work"]).max(), 1e-300)
    scale += curve["dissipated_energy"].max()
    found = []
    for step in (step for step in steps if step.number < len(curve)):
        beyond = curve["stored_energy"][step.number] - stored_energy(step)  # weak springs count where bodies are joined
        found.append((max(-beyond, beyond - step.weak_energy, 0) / scale, f"step {step.number}"))
    return worst_of(name, found, ENERGY)


def agrees_with_curve(steps, curve, forces):
    """Load factors and reactions of curve.csv are those of the fields; reactions to a couple are but rounding."""
    found, least = [], FORCE * max((np.nanmax(scale, initial=0.0) for _, scale in forces), default=0.0)
    for step in steps:
        if step.number >= len(curve):
            found.append((np.inf, f"step {step.number} has no row"))
            continue
        row, springs = curve.iloc[step.number], step.model.springs
        sums = {"load_factor": (step.load_factor, 0.0)}
        for name, force, noise in zip(springs["names"], step.spring_forces, step.told_noise):
            column = name if name in curve and f"reaction_{name}" not in curve else f"reaction_{name}"
            sums[column] = tuple(map(sum, zip(sums.get(column, (0.0, 0.0)), (force, noise))))
        for column, (value, noise) in sums.items():
            if column not in curve:
                continue
            scale = max(np.abs(curve[column]).max(), least if column != "load_factor" else 0.0, 1e-300)
            error = abs(value - row[column]) - noise
            found.append((max(error, 0) / scale if error == error else error, f"step {step.number}, {column}"))
    return worst_of("fields agree with curve.csv", found, CURVE)


def all_checks(steps, curve, is_carried):
    """`is_carried` is false where the dead loads could not be brought to their full value."""
    forces = [residuals(step) for step in steps]
    balanced = [equilibrium(steps, forces), reactions_carry(steps)]
    if not is_carried:
        balanced = [not_made(found.check, "the dead loads were not carried in full") for found in balanced]
    return [*balanced, envelope(steps), normal_law(steps), multipliers_settled(steps), damage_grows(steps), displacements(steps),
            stored_energies(steps, curve), agrees_with_curve(steps, curve, forces)]
