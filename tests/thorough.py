"""Two sizes of one suite: `make test`, and `make test-all`, which tries the same on far more cases.

What is named here repeats a property on more bodies, networks, seeds or devices, or costs more than it tells; `make
test` runs the cases in brackets. Random examples are fewer there as well.
"""

import os
from collections.abc import Iterable, Mapping

import pytest

# Set by `conftest.py` from `--thorough`; processes that share the tests inherit it.
VARIABLE = "COTOUCH_TESTS_THOROUGH"

# Of tetrahedra one law is enough where bodies move: the machine code of a step takes as long to compile for each.
STEPPED = ("floating", "cells", "spring-network", "elastic floating", "neo-hookean", "rigid")
# Cases of a test that always run, as `-k` would find them in its brackets; none: the test is thorough as a whole.
QUICK: Mapping[str, tuple[str, ...]] = {
    "body/test_eigenspaces.py::test_members_on_other_processors_build_the_same_shapes": ("Sandybridge",),
    "body/test_meshes.py::test_turning_the_mesh_turns_the_elastic_body": (),
    "body/test_truncation.py::test_sparse_modes_are_the_dense_ones": ("True",),
    "cli/test_cli.py::test_simulate_says_what_tools_felt_and_writes_an_animation": (),
    "cli/test_full_disk.py::test_a_demonstration_on_a_full_disk": (),
    "cli/test_full_disk.py::test_a_recording_that_cannot_be_is_refused_before_anything_else": ("nowhere",),
    "cli/test_full_disk.py::test_the_table_shows_whose_recording_stopped": (),
    "cli/test_interrupted.py::test_a_command_at_work_ends": ("0.2-arguments0",),
    "cli/test_interrupted.py::test_a_command_that_compiles_ends": ("arguments1",),
    "cli/test_laboratory_commands.py::test_compare_names_a_law_that_makes_energy_although_it_promises_not_to": (),
    "cli/test_laboratory_commands.py::test_compare_says_why_a_cell_is_empty": (),
    "cli/test_laboratory_commands.py::test_simulate_says_what_the_law_made": (),
    "cli/test_outputs.py::TestStandardOutput::test_closed": ("command0",),
    "cli/test_outputs.py::TestStandardOutput::test_full": ("command0",),
    "cli/test_outputs.py::TestStandardOutput::test_nobody_reads_on": ("command1",),
    "cli/test_outputs.py::test_a_full_disk": ("x.nc---out",),
    "cli/test_outputs.py::test_a_full_disk_and_smaller_outputs": (),
    "cli/test_outputs.py::test_a_limit_on_files": (),
    "cli/test_outputs.py::test_a_pipe_in_place_of_a_file_is_a_sentence": ("command1",),
    "cli/test_outputs.py::test_links_and_devices_stay_what_they_are": (),
    "cli/test_outputs.py::test_two_with_the_same_file_both_succeed": (),
    "cli/test_plan_command.py::test_nothing_is_said_of_a_run_where_the_slowest_modes_are_alike": (),
    "cli/test_plan_command.py::test_the_knee_figure_shows_what_the_plan_says": (),
    "cli/test_session_commands.py::test_demo": ("options0",),
    "control/test_control.py::test_a_dead_members_presence_cannot_be_made_up": ("memory", "routed"),
    "control/test_control.py::test_a_file_is_fetched_by_its_hash": (
        "memory-0",
        "memory-1",
        "memory-262144",
        "memory-262145",
        "memory-10485760",
        "routed-262145",
        "zenoh-262145",
    ),
    "control/test_control.py::test_a_newcomer_is_not_told_of_the_dead": ("memory", "zenoh"),
    "control/test_control.py::test_who_is_there_cannot_be_made_absent": ("memory", "zenoh"),
    "control/test_control_fuzz.py::test_a_million_messages": (),
    "control/test_control_processes.py::test_without_the_secret_nobody_joins": (),
    "control/test_gate.py::test_the_invited_join_however_many_strangers_are_at_the_door": ("silent-300-0",),
    "device/test_modulation.py::test_two_ports_with_a_proxy_are_passive": (
        "0.001-0.001-plant1",
        "0.00025-0.01-plant0",
        "0.001-0.0371-plant1",
    ),
    "drivers/test_critical.py::test_a_mutant_is_noticed": ("0", "3", "6", "9", "12", "15", "18"),
    "drivers/test_processes.py::test_a_guardian_that_is_stopped_or_killed_leaves_no_force": ("touch",),
    "drivers/test_processes.py::test_a_peer_that_is_killed_leaves_no_force_and_no_process": ("force_dimension",),
    "drivers/test_processes.py::test_a_peer_that_is_stopped_leaves_no_force_and_with_its_servo_neither": ("haply",),
    "drivers/test_processes.py::test_a_servo_that_is_killed_leaves_no_force": ("haply",),
    "drivers/test_processes.py::test_a_servo_that_is_stopped_leaves_no_force": ("force_dimension",),
    "drivers/test_processes.py::test_peer_and_servo_that_are_killed_at_once_leave_no_force": ("force_dimension",),
    "drivers/test_session.py::test_an_inverse3_takes_part_until_it_is_unplugged_and_the_others_go_on": (),
    "haptics/test_ends.py::test_two_ports_are_passive_whatever_the_rates_and_boards": (
        "3",
        "11",
        "22",
    ),
    "haptics/test_processes.py::test_a_guardian_that_is_killed_leaves_no_force": (),
    "haptics/test_processes.py::test_a_limit_above_the_devices_own_is_a_sentence": (),
    "haptics/test_processes.py::test_a_peer_that_is_killed_leaves_no_force_and_no_process": (),
    "haptics/test_processes.py::test_a_refused_priority_is_said_once": (),
    "haptics/test_processes.py::test_a_servo_finds_the_coupling_of_another_package": (),
    "haptics/test_processes.py::test_a_servo_that_is_killed_leaves_no_force": (),
    "haptics/test_processes.py::test_a_servo_that_stands_still_leaves_no_force": (),
    "haptics/test_processes.py::test_the_simulated_device_is_felt_outlasts_a_servo_that_stood_still_and_is_closed": (
        "simulated:touch,viscous=4,coupling=virtual,friction=4,coulomb=0.2",
    ),
    "laboratory/test_replicas.py::test_without_delay_and_with_ever_shorter_steps_replicas_are_the_ideal": (
        "broadcast",
        "owner",
        "rollback",
    ),
    "laws/test_known_answers.py::test_paid_lets_another_block_rest_over_a_longer_way": (),
    "laws/test_known_answers.py::test_paid_makes_no_more_than_its_seed_where_tools_touch": ("75",),
    "laws/test_known_answers.py::test_to_paid_fingers_that_lift_a_block_between_them_are_felt_by_both": ("weightless",),
    "laws/test_worlds.py::test_spring_as_a_law_is_the_spring_to_the_bit": ("constant-False", "freshest-False"),
    "live/test_moving.py::test_members_that_moved_find_each_other_and_need_no_host_for_it": (),
    "live/test_nats.py::test_ports_are_kept": (),
    "live/test_nats.py::test_ports_are_random": (),
    "live/test_networks.py::test_five_processes_on_this_machine": (),
    "live/test_networks.py::test_the_papers_network_and_worse": (),
    "live/test_networks.py::test_the_star_keeps_its_laws": (),
    "mechanics/test_bold.py::test_a_body_that_a_great_force_pulls_within_long_steps_goes_on": (
        "cells",
        "elastic floating",
        "floating",
        "neo-hookean",
        "spring-network",
    ),
    "mechanics/test_contact_material.py::test_a_turned_floating_flat_pushes_as_the_closed_form_says": (),
    "mechanics/test_contact_material.py::test_one_balance_for_contact_and_material": ("cells-0",),
    "mechanics/test_contact_material.py::test_sliding_over_rows_of_vertices": ("cells",),
    "mechanics/test_contact_material.py::test_steps_that_are_far_too_long_close_all_the_same": (
        "cells-ball",
        "spring-network-grasp",
        "neo-hookean-stylus",
    ),
    "mechanics/test_cutting.py::test_what_is_left_moves_on_in_balance": ("spring-network", "cells", "neo-hookean"),
    "mechanics/test_force.py::test_a_bent_body_hardly_needs_its_closure": STEPPED,
    "mechanics/test_force.py::test_a_falling_body_falls": ("cells", "rigid"),
    "mechanics/test_force.py::test_a_free_turn_keeps_shape_and_momentum": STEPPED,
    "mechanics/test_force.py::test_copies_in_step_are_one_body": STEPPED,
    "mechanics/test_force.py::test_garbage_directions_cost_no_energy": (
        "cells",
        "elastic floating",
        "neo-hookean",
        "spring-network",
    ),
    "mechanics/test_force.py::test_the_balance_is_exact_however_early_the_solver_stops": (
        "cells-2",
        "elastic floating-1",
        "floating-1",
        "neo-hookean-200",
        "rigid-2",
        "spring-network-3",
    ),
    "mechanics/test_force.py::test_the_energy_of_what_is_squashed_follows_from_its_place": ("floating",),
    "mechanics/test_force.py::test_the_motion_converges_to_second_order": STEPPED,
    "mechanics/test_force.py::test_what_spins_about_no_axis_of_its_own_keeps_its_angular_momentum": STEPPED,
    "mechanics/test_grasp.py::test_a_body_with_a_material_is_carried": ("cells",),
    "mechanics/test_impact.py::test_what_flies_and_rings_in_steps_that_are_too_long_flies_on": (
        "cells",
        "neo-hookean",
        "spring-network",
    ),
    "mechanics/test_meeting.py::test_a_block_rests_on_a_mesh_that_stands_still": ("1200",),
    "mechanics/test_meeting.py::test_a_tower_of_five_stands": ("500-rigid", "500-cells"),
    "mechanics/test_rigid.py::test_a_block_rests": ("3000",),
    "mechanics/test_world.py::test_a_block_rests_for_a_minute": (),
    "mechanics/test_world.py::test_nothing_passes_at_ten_metres_a_second": ("shape0-springs", "shape1-springs"),
    "members/test_lies.py::test_a_newcomer_comes_to_where_a_deformed_object_is_held": ("second",),
    "members/test_live_law.py::test_nothing_is_made_whatever_becomes_of_the_network_and_its_members": ("0",),
    "members/test_live_law.py::test_two_carry_an_object": ("paid", "wave"),
    "members/test_live_law.py::test_who_lies_gains_no_more_than_limits_allow": ("rich", "waves", "the past"),
    "members/test_member.py::test_a_bad_network": (),
    "members/test_member.py::test_a_constant_index_delay_couples_too": ("constant",),
    "members/test_member.py::test_one_goes_and_the_others_go_on": ("kill",),
    "members/test_succession.py::test_who_comes_back_to_a_place_that_was_given_away_gives_way_to_the_others": (),
    "network/test_returns.py::test_what_is_excluded_is_empty_and_no_turn_is_lost": ("0", "4", "9"),
    "planning/test_counts.py::test_links_that_are_forbidden_are_not_swapped_in": (),
    "planning/test_counts.py::test_springs_decide_which_links_are_best": (),
    "planning/test_limits.py::test_limits_on_damping_and_drag_against_brute_force": ("damping",),
    "planning/test_local.py::test_few_starts_find_the_best_of_all_choices": (),
    "planning/test_plan.py::test_three_ways_agree_on_random_networks": ("1",),
    "planning/test_springs.py::test_never_worse_and_within_the_limits": (),
    "planning/test_springs.py::test_the_papers_best_topology": (),
    "planning/test_workers.py::test_processes_of_a_dask_cluster_find_the_same_whoever_is_lost": (),
    "samples/test_fuzz.py::test_a_million_datagrams": (),
    "samples/test_rate.py::test_a_narrow_path_is_filled_but_not_flooded": ("0.02-100.0", "0.5-500.0", "5.0-850.0"),
    "samples/test_rate.py::test_a_path_that_is_merely_bad_is_used_in_full": ("law0-0", "law1-1", "law2-2"),
    "session/test_heavy.py::test_rests_without_creep_whoever_comes_and_goes": ("spring-1e-05-1e-06",),
    "session/test_nats.py::test_two_behind_nats_feel_each_other": ("random-relayed",),
    "session/test_networks.py::test_partition_one_way_outage_crash_of_a_member_and_of_the_host": (),
    "session/test_networks.py::test_the_papers_network_with_jitter_reordering_and_loss": (),
    "session/test_planner.py::test_the_one_at_the_end_of_a_slow_line_is_joined_where_it_is_nearest": ("drag",),
    "session/test_real_cut.py::test_one_cuts_and_both_have_the_same_cut": (),
    "session/test_recording.py::test_a_session_that_touches_by_a_law_keeps_an_exact_ledger": (),
    "session/test_recovery.py::test_a_run_without_a_fault_is_the_same_every_time": (),
    "session/test_recovery.py::test_all_is_as_if_nothing_had_been": ("all at once",),
    "session/test_recovery.py::test_with_a_law_that_pays_all_is_as_if_nothing_had_been": (),
    "session/test_replan.py::test_who_moved_away_is_joined_where_it_is_now": (),
    "session/test_short_faults.py::test_a_process_that_stood_still_and_other_addresses": (),
    "simulation/test_animation.py::test_a_browser_that_cannot_says_so": ("delete window.DecompressionStream-too old",),
    "simulation/test_animation.py::test_ghosts_show_where_copies_differ": (),
    "simulation/test_animation.py::test_it_fits_a_phone": (),
    "simulation/test_animation.py::test_it_stands_still_for_those_who_want_that": (),
    "simulation/test_animation.py::test_keys_are_explained": (),
    "simulation/test_animation.py::test_legend_and_table_say_what_is_seen": (),
    "simulation/test_animation.py::test_light_and_dark": ("dark",),
    "simulation/test_animation.py::test_nodes_without_a_surface": ("edges1",),
    "simulation/test_animation.py::test_one_copy_alone": (),
    "simulation/test_animation.py::test_side_by_side_shows_each_copy": (),
    "simulation/test_animation.py::test_the_playhead_can_be_dragged": (),
    "simulation/test_animation.py::test_the_table_shows_no_force_where_there_is_none": (),
    "simulation/test_animation.py::test_turning_zooming_and_the_first_view_again": (),
    "simulation/test_bodies.py::test_a_body_that_meets_itself_does_so_in_every_world_to_the_same_bits": (),
    "simulation/test_bodies.py::test_a_tool_slides_over_a_stiff_uneven_one_of_several": (),
    "simulation/test_bodies.py::test_a_tool_that_pushes_one_body_leaves_another_at_rest": (),
    "simulation/test_bodies.py::test_peers_come_to_the_same_bits": ("paid",),
    "simulation/test_bodies.py::test_several_are_cut_in_every_world_to_the_same_bits": ("peers",),
    "simulation/test_bodies.py::test_what_is_pressed_into_itself_comes_out_as_soon_as_its_grasp_pulls": (),
    "simulation/test_contact.py::test_both_engines_touch_alike_and_balance_it": ("linear",),
    "simulation/test_cutting_beside_tools.py::test_a_blade_cuts_what_a_plate_presses": (),
    "simulation/test_examples.py::test_energy_balances_and_everything_is_passive": ("alone", "squeeze", "two_rates"),
    "simulation/test_examples.py::test_five_users_pull_one_liver_and_let_go": (),
    "simulation/test_figures.py::test_a_run_that_diverges": ("20.0",),
    "simulation/test_long_steps.py::test_the_balance_is_exact": (),
    "simulation/test_materials.py::test_a_tool_touches_a_body_that_turns": (),
    "simulation/test_result.py::test_a_run_at_rest_has_nothing_to_balance": ("fixed",),
    "simulation/test_rigid.py::test_both_engines_move_it_alike_and_balance_it": ("hand",),
    "simulation/test_tools_side_by_side.py::test_a_ball_that_waits_changes_nothing": (),
    "simulation/test_world.py::test_peers_come_to_the_same_bits": ("it falls",),
    "simulation/test_world.py::test_two_hands_lift_a_block_off_a_table": (),
    "study/test_confirm.py::test_tuned_springs_of_the_papers_network": (),
    "study/test_solid.py::TestBlocks::test_ports_in_a_row_carry_what_the_hands_put_in": (),
    "study/test_touch_record.py::test_findings_are_kept_and_taken_up_again": (),
    "test_compiled.py::test_a_large_kernel_is_called_and_not_copied": (),
    "test_compiled.py::test_two_processes_that_number_their_files_alike_are_told_apart": (),
    "test_compiled.py::test_what_only_kernels_call_has_no_machine_code": (),
    "test_compiled.py::test_what_processes_have_kept_is_not_taken_for_a_namesake": (),
    "test_compiled.py::test_who_calls_what_has_another_symbol_now_is_compiled_anew": (),
    "test_interpreters.py::test_the_core_gives_the_same_numbers": ("3.12", "3.13"),
    "test_leftovers.py::test_nothing_is_left": ("SIGKILL", "Ctrl-C"),
    "test_processors.py::test_nor_do_all_the_others": (),
    "test_processors.py::test_numbers_do_not_depend_on_the_processor": ("SSE4",),
    "test_soak.py::test_pages_of_files_are_told_from_memory": (),
    "traversal/test_routed.py::test_a_machine_that_gets_another_address_is_reached_straight_again": (
        "1.0-nats3",
        "0.0-nats0",
    ),
    "web/test_picture.py::test_a_slider_is_dragged_on_its_rail_and_the_others_follow": (),
    "web/test_picture.py::test_how_things_are_is_told_where_no_picture_is_drawn": (),
    "web/test_picture.py::test_keys_grab_move_and_let_go": (),
    "web/test_picture.py::test_numbers_in_the_picture_change_as_often_as_they_can_be_read": (),
    "web/test_picture.py::test_one_finger_pulls_and_two_turn_and_zoom": (),
    "web/test_picture.py::test_pointers_are_few_and_the_last_counts": (),
    "web/test_picture.py::test_side_by_side_every_copy_has_its_name_and_delay": (),
    "web/test_picture.py::test_the_page_survives_the_servers_restart": (),
    "web/test_picture.py::test_what_is_held_is_held_again_after_the_connection_was_lost": (),
    "web/test_picture_kinds.py::test_a_body_without_a_skin_is_seen_and_held": ("bare",),
    "web/test_picture_kinds.py::test_a_gamepad_moves_the_hand_and_its_motors_tell_the_force": ("3d",),
    "web/test_picture_kinds.py::test_every_window_has_a_picture": ("360-640",),
    "web/test_picture_kinds.py::test_nodes_and_the_edges_between_them_are_drawn": ("2d",),
    "web/test_picture_kinds.py::test_of_a_ghost_only_what_differs_is_drawn": (),
    "web/test_picture_kinds.py::test_the_picture_gets_coarser_where_it_is_late_and_finer_where_it_is_not": (),
    "web/test_picture_kinds.py::test_what_is_drawn_can_be_chosen": (),
    "web/test_picture_kinds.py::test_who_asked_for_less_motion_is_where_he_turned_to_at_once": ("reduce",),
    "web/test_real_join.py::test_who_joins_with_a_device_holds_the_object_from_the_first_moment": (),
    "web/test_screen.py::test_a_movement_is_told_once": (),
    "web/test_screen.py::test_a_way_that_gets_short_is_not_taken_for_a_missed_picture": (),
    "web/test_screen.py::test_frames_come_just_before_a_picture": (),
    "web/test_shell.py::test_a_scripted_hand_can_be_told": (),
    "web/test_shell.py::test_an_invitation_is_shown_and_a_slot_freed": (),
    "web/test_shell.py::test_an_old_token_is_told_and_offers_nothing": (),
    "web/test_shell.py::test_cutting_a_link_shows_in_the_graph_the_card_and_the_verdict": (),
    "web/test_shell.py::test_whoever_takes_part_from_elsewhere_is_sent_away_after_a_question": (),
    "web/test_shell_instruments.py::test_frozen_plots_stand_still_and_are_saved": (),
    "web/test_shell_instruments.py::test_plots_draw_and_hold_no_growing_memory": (),
    "web/test_shell_instruments.py::test_the_share_of_the_damping_begins_where_the_body_shakes": ("1d-5 %-0.1 %",),
    "web/test_shell_instruments.py::test_what_is_plotted_and_saved_is_the_same_on_every_page": (),
    "web/test_shell_reach.py::test_all_that_is_seen_stands_out_from_what_is_behind_it": ("light",),
    "web/test_shell_reach.py::test_the_tour_covers_nothing_that_it_speaks_of": ("size0",),
    "web/test_shell_reach.py::test_the_tour_invites_runs_through_and_is_taken_up_again": (),
    "web/test_shell_reach.py::test_the_tour_never_blocks_and_fits_a_phone": (),
    "web/test_silence.py::test_a_server_that_never_answered_is_said": (),
}


def examples(count: int) -> int:
    """Of so many examples: an eighth, 8 at least, unless all are wanted."""
    return count if os.environ.get(VARIABLE) else min(count, max(8, count // 8))


def split(nodeid: str) -> tuple[str, str]:
    """A test's name without its file's room, as above, and what stands in its brackets.

    Args:
        nodeid: its name, as pytest says it.
    """
    name, _, case = nodeid.removeprefix("tests/").partition("[")
    return name, case.removesuffix("]")


def unknown(nodeids: Iterable[str]) -> list[str]:
    """Cases named above that are not among those of a test that is there, so that nothing is left out by a typo.

    Args:
        nodeids: of everything that was found in the files in question.
    """
    found: dict[str, set[str]] = {}
    for name, case in map(split, nodeids):
        found.setdefault(name, set()).add(case)
    files = {name.partition("::")[0] for name in found}
    wanted = {name: cases for name, cases in QUICK.items() if name.partition("::")[0] in files}
    return [
        *(name for name in wanted if name not in found),
        *(f"{name}[{case}]" for name, cases in wanted.items() for case in cases if case not in found.get(name, {case})),
    ]


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Marks them, and leaves them out unless all are wanted or somebody names one."""
    for item in items:
        name, case = split(item.nodeid)
        if name in QUICK and case not in QUICK[name]:
            item.add_marker("thorough")
    if any("::" in name for name in config.args):
        return
    if wrong := unknown(item.nodeid for item in items):
        message = f"tests/thorough.py names what is not there: {', '.join(wrong)}"
        raise pytest.UsageError(message)
    if config.getoption("--thorough"):
        return
    left = [item for item in items if item.get_closest_marker("thorough")]
    if left:
        config.hook.pytest_deselected(items=left)
        items[:] = [item for item in items if not item.get_closest_marker("thorough")]
