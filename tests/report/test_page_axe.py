# SPDX-License-Identifier: MIT
"""The page by axe-core: no violation, in light and dark, on a desk and on a phone."""

import shutil
import subprocess
from pathlib import Path

import pytest
from browser import SIZE, SOFTWARE_GL
from locks import locked
from test_page import browse, write  # noqa: F401
from test_page_part import SLOT
from test_report import PART

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_S = 60
RULES = """async () => {
    const { violations, passes } = await axe.run(document);
    return [passes.length, violations.map(({ id, nodes }) =>
        [id, ...nodes.slice(0, 3).map(({ html, failureSummary }) =>
            `${html.slice(0, 120)}: ${failureSummary}`)])];
}"""


@pytest.fixture(scope="module")
def axe():
    """Return the script of axe-core, as page/package-lock.json has it; npm fetches it once."""
    folder = ROOT / "build" / "axe"
    script = folder / "node_modules/axe-core/axe.min.js"
    with locked(folder):
        if not script.exists():
            npm = shutil.which("npm") or pytest.skip("npm is not there: NO RULE OF AXE WAS TRIED")
            folder.mkdir(parents=True, exist_ok=True)
            for name in ("package.json", "package-lock.json"):
                shutil.copy(ROOT / "page" / name, folder)
            try:
                subprocess.run(
                    [npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund"],
                    cwd=folder, check=True, capture_output=True, timeout=PATIENCE_S,
                )  # fmt: skip
            except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as cause:
                pytest.skip(f"npm brings no axe-core: NO RULE OF AXE WAS TRIED: {cause}")
    return script.read_text(encoding="utf-8")


@pytest.mark.parametrize("size", [SIZE, {"width": 390, "height": 844}], ids=["desk", "phone"])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_no_violation(browse, tmp_path, axe, scheme, size):  # noqa: F811
    for text, shown in ((PART, "path"), (SLOT, "part")):
        with browse(write(tmp_path, text), *SOFTWARE_GL, scheme=scheme, size=size) as visit:
            visit.page.locator(".cause summary").first.click()
            visit.page.click(f"#shows [data-name={shown}]")
            visit.settle()
            visit.ask(axe)
            passed, broken = visit.ask(RULES)
            assert broken == []
            assert passed > 20


def test_axe_would_find_one(browse, tmp_path, axe):  # noqa: F811
    with browse(write(tmp_path, PART), *SOFTWARE_GL) as visit:
        visit.ask("document.getElementById('rate').removeAttribute('aria-label')")
        visit.ask(axe)
        _, broken = visit.ask(RULES)
        assert "select-name" in [rule for rule, *_ in broken]
