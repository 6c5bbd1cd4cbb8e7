"""Commands of the pages that test_commands.py does not run, by what they begin with, and why. Each entry is on some page."""

BUILDS = "builds the program that is tested"
CAMPAIGN = "a campaign without an end of its own; its parts are among the nightly tests"

ELSEWHERE = {
    "./bootstrap test": "is what runs this test",
    "./bootstrap build": BUILDS,
    "./bootstrap site": "tests/site/test_site.py builds it",
    "cmake --preset": BUILDS,
    "cmake --build": BUILDS,
    "build/release/bin/fuzz": "tests/fuzz has a portion of the campaign",
    "mpirun": "tests/program/test_ranks.py",
    "dda run deck.yaml --plugin": "tests/install/test_plugin.py, with the plugin compiled",
    "dda sweep FILE --launcher": "tests/program/run_slurm_tests.sh and run_shared_sweep_tests.sh",
    "dda sweep --status": "tests/program/run_shared_sweep_tests.sh",
    "python3 -m ddapath scene": "tests/python/test_scenes.py, on pictures and meshes of its own",
    "contact_matrix.py": CAMPAIGN,
    "dry_masonry.py": CAMPAIGN,
    "mortar_walls.py": CAMPAIGN,
    "run.py": CAMPAIGN,
    "kill_campaign.py": CAMPAIGN,
    "./bootstrap run studies/paper/sweep.yaml": "all studies of a paper: an hour; its decks are run by tests/studies/test_every_deck.py",
    "./bootstrap report runs/paper": "the report of that; tests/report has reports of sweeps",
    # Studies, whose short forms are tests.
    "./bootstrap study bodies-in-motion": "tests/studies/test_bodies_in_motion.py",
    "./bootstrap study classic-and-free-flight": "tests/studies/test_classic_and_free_flight.py",
    "./bootstrap study crack-paths": "an hour; tests/studies/test_every_deck.py runs its decks",
    "./bootstrap study falling-beam": "tests/studies/test_falling_beam.py",
    "./bootstrap study kitoh-beam": "tests/studies/test_kitoh_beam.py",
    "./bootstrap study many-ranks": "tests/studies/test_many_ranks.py",
    "./bootstrap study masonry-in-motion": "tests/studies/test_motion_studies.py",
    "./bootstrap study rock-slope": "tests/studies/test_motion_studies.py",
    "./bootstrap study rubble-wall": "tests/studies/test_rubble_wall.py",
    "./bootstrap study run-time-against-error": "tests/studies/test_run_time_against_error.py",
    "./bootstrap study scaling": "tests/studies/test_scaling.py",
    "./bootstrap study size-effect": "tests/studies/test_size_effect.py",
    "./bootstrap study stability": "tests/studies/test_stability.py",
}

# Lines of the tutorials that take long; test_commands.py looks at their options all the same.
TOO_LONG = {
    "dda animate runs/fall": "a film of a minute; tests/python/test_animation.py makes a short one",
    "dda sweep reinforced.yaml": "three long paths; tests/studies has the study reinforced-beam",
    "dda verify runs/fall": "a minute; tests/program verifies motions",
}
