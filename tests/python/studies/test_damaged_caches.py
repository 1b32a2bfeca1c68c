"""A damaged cache gives the undamaged results, or an error that names the file, the point and the remedy."""

from __future__ import annotations

import contextlib
import re
import sqlite3

import pytest
from campaign.files.caches import check, study
from shared_cases import command
from viscoroll.case import example_text


def changed(folder, statement):
    with contextlib.closing(sqlite3.connect(folder / "study.nc.points", isolation_level=None)) as database:
        assert database.execute(statement).rowcount != 0


@pytest.fixture
def cached(tmp_path):
    """Return the folder and the study of a complete cache."""
    return tmp_path, study(tmp_path / "study.nc")


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE point SET scalars = replace(scalars, '1', '2')",  # valid JSON with other numbers
        "UPDATE point SET fields = draws",
        "UPDATE point SET error = 'x'",
        "UPDATE point SET draws = NULL",
        "UPDATE point SET checksum = zeroblob(32)",
        "UPDATE point SET scalars = CAST(x'ff00ff' AS TEXT)",
    ],
)
def test_a_damaged_point_is_named_and_solved_again_on_request(cached, statement):
    folder, before = cached
    changed(folder, f"{statement} WHERE rowid = (SELECT max(rowid) FROM point)")
    wanted = r"study.nc.points is damaged at point [1-4] of 4: solve .* retry_failed=True .*, or delete it and study.nc"
    with pytest.raises(ValueError, match=wanted):
        study(folder / "study.nc")
    found = study(folder / "study.nc", retry_failed=True)
    assert found.resisting_torque.equals(before.resisting_torque)
    assert study(folder / "study.nc").identical(found)


def test_a_row_of_another_point_counts_as_damaged(cached):
    """A damaged index may find a row whose checksum is that of another point."""
    folder, _ = cached
    columns = ("scalars", "fields", "draws", "error", "checksum")
    others = ", ".join(f"{name} = (SELECT {name} FROM point WHERE rowid = 1)" for name in columns)
    changed(folder, f"UPDATE point SET {others} WHERE rowid = 2")
    with pytest.raises(ValueError, match="is damaged at point"):
        study(folder / "study.nc")


def test_a_study_file_with_one_changed_bit_is_rejected(cached):
    """The cache stores a checksum of the netCDF file, because netCDF has none."""
    folder, before = cached
    path = folder / "study.nc"
    content = bytearray(path.read_bytes())
    content[content.index(before.resisting_torque.values.tobytes())] ^= 1
    path.write_bytes(content)
    with pytest.raises(
        ValueError, match=r"study.nc is damaged, or does not belong .*: delete it, and the same call makes"
    ):
        study(path)
    path.unlink()
    assert study(path).resisting_torque.equals(before.resisting_torque)


@pytest.mark.parametrize(
    ("statement", "wanted"),
    [
        (
            "ALTER TABLE point DROP COLUMN checksum",
            r"is damaged, or is not a file .* \(its tables are different\): delete it",
        ),
        ("UPDATE made_by SET text = 'a' || char(10) || x'ff'", r".*got a cache made by a\\n.*: delete it and study.nc"),
        ("DELETE FROM made_by", ".*got a cache made by None.*: delete it and study.nc"),
        ("DROP TABLE made_by", r".*\(SQLITE_ERROR\): delete it and study.nc"),
        ("PRAGMA application_id = 7", r"is damaged, or is not a file .*: delete it and study.nc"),
    ],
)
def test_another_database_is_rejected(cached, statement, wanted):
    folder, _ = cached
    changed(folder, statement)
    with pytest.raises(ValueError, match=rf"study.nc.points {wanted}"):
        study(folder / "study.nc")


@pytest.mark.parametrize("size", [2, 1000, 4096, 9000, -1000])
def test_a_truncated_database_is_rejected(cached, size):
    folder, before = cached
    points = folder / "study.nc.points"
    points.write_bytes(points.read_bytes()[:size])
    with pytest.raises(ValueError, match=r"study.nc.points is damaged.* delete it and study.nc to start again"):
        study(folder / "study.nc")
    for file in folder.iterdir():
        file.unlink()
    assert study(folder / "study.nc").resisting_torque.equals(before.resisting_torque)


def test_the_command_line_names_the_remedy(tmp_path):
    text = example_text("case").replace("accuracy = 0.01", "accuracy = 0.3")
    (tmp_path / "study.toml").write_text(text + '\n[sweep]\n"rolling.load" = [50.0, 60.0]\n')
    assert command("sweep", "study.toml", cwd=tmp_path).returncode == 0
    changed(tmp_path, "UPDATE point SET error = 'x' WHERE rowid = 2")
    done = command("sweep", "study.toml", cwd=tmp_path)
    assert done.returncode == 2
    assert re.fullmatch(
        "viscoroll: cache study.nc.points is damaged at point . of 2: .*--retry-failed.*\n", done.stderr
    )
    assert command("sweep", "study.toml", "--retry-failed", cwd=tmp_path).returncode == 0
    assert command("sweep", "study.toml", cwd=tmp_path).returncode == 0


@pytest.mark.parametrize("seed", range(12))
def test_random_damage(tmp_path, seed):
    assert check(seed, tmp_path) is None
