"""The findings of OpenUSD and the validators: paths on standard input, a JSON list on standard output.

Arguments choose among the checks; without any, all run.

A separate program, because the schemas that OpenUSD knows are fixed when its process starts.
"""

import json
import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache

from pxr import Sdf, Sdr, Tf, Usd, UsdUtils

try:
    from pxr import UsdValidation
except ImportError:
    UsdValidation = None
try:
    import usd_validation_nvidia
except ImportError:
    usd_validation_nvidia = None


@contextmanager
def console(into: list[str]) -> Iterator[None]:
    """Captures all output to the two console descriptors, including output of C++ code."""
    sys.stdout.flush()
    sys.stderr.flush()
    saved = os.dup(1), os.dup(2)
    with tempfile.TemporaryFile() as caught:
        os.dup2(caught.fileno(), 1)
        os.dup2(caught.fileno(), 2)
        try:
            yield
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os.dup2(saved[0], 1)
            os.dup2(saved[1], 2)
            os.close(saved[0])
            os.close(saved[1])
            caught.seek(0)
            into += caught.read().decode(errors="replace").splitlines()


def read_everything(path: str) -> list[str]:
    """Opens a stage, reads every value, and returns the composition errors."""
    stage = Usd.Stage.Open(path)
    for prim in stage.TraverseAll():
        for attribute in prim.GetAttributes():
            attribute.Get()
        for relationship in prim.GetRelationships():
            relationship.GetTargets()
    errors = getattr(stage, "GetCompositionErrors", list)()
    return [str(error) for error in errors]


def type_mismatches(path: str) -> list[str]:
    """Authored attributes and relationships whose type or variability differs from their schema's."""
    found = []
    stage = Usd.Stage.Open(path)
    for prim in stage.TraverseAll():
        definition = prim.GetPrimDefinition()
        for prop in prim.GetAuthoredProperties():
            spec = definition.GetSchemaPropertySpec(prop.GetName())
            if spec is None:
                continue
            for authored in prop.GetPropertyStack(Usd.TimeCode.Default()):
                if type(authored) is not type(spec):
                    found.append(f"{prop.GetPath()}: attribute and relationship mixed up")
                elif isinstance(spec, Sdf.AttributeSpec) and authored.typeName != spec.typeName:
                    found.append(f"{prop.GetPath()}: {authored.typeName}, the schema has {spec.typeName}")
                elif authored.variability != spec.variability:
                    found.append(f"{prop.GetPath()}: {authored.variability}, the schema has {spec.variability}")
    return found


def unknown_properties(path: str) -> list[str]:
    """Attributes in the sensors' and lenses' name spaces that no applied schema declares."""
    found = []
    stage = Usd.Stage.Open(path)
    for prim in stage.TraverseAll():
        known = set(prim.GetPrimDefinition().GetPropertyNames())
        spaces = ("omni:rtx:post:depthSensor:", "omni:lensdistortion:")
        found += [
            str(prop.GetPath())
            for prop in prim.GetAuthoredProperties()
            if prop.GetName().startswith(spaces) and prop.GetName() not in known
        ]
    return found


def compliance_checker(path: str) -> list[str]:
    checker = UsdUtils.ComplianceChecker(arkit=False, skipARKitRootLayerCheck=False)
    checker.CheckCompliance(path)
    found = checker.GetErrors() + checker.GetFailedChecks() + checker.GetWarnings()
    if not knows_preview_surface():
        found = [line for line in found if "has invalid shader node" not in line]
    return found


@cache
def knows_preview_surface() -> bool:
    """The wheel of OpenUSD 24.5 lacks the definitions of its own shaders, and warns once about it."""
    try:
        Sdr.Registry().GetShaderNodeByIdentifier("UsdPreviewSurface")
    except Tf.ErrorException:
        pass
    return Sdr.Registry().GetShaderNodeByIdentifier("UsdPreviewSurface") is not None


def usd_validation(path: str) -> list[str]:
    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    errors = context.Validate(Usd.Stage.Open(path))
    return [f"{error.GetValidator().GetMetadata().name}: {error.GetMessage()}" for error in errors]


def nvidia(path: str) -> list[str]:
    issues = usd_validation_nvidia.ValidationEngine().validate(path).issues()
    return [f"{issue.rule.__name__ if issue.rule else '-'}: {issue.message} ({issue.at})" for issue in issues]


CHECKS: dict[str, Callable[[str], list[str]]] = {
    "composition": read_everything,
    "types": type_mismatches,
    "unknown": unknown_properties,
}
if hasattr(UsdUtils, "ComplianceChecker"):
    CHECKS["ComplianceChecker"] = compliance_checker
if UsdValidation is not None:
    CHECKS["UsdValidation"] = usd_validation
if usd_validation_nvidia is not None:
    CHECKS["usd-validation-nvidia"] = nvidia


def findings(path: str, chosen: list[str]) -> dict[str, list[str]]:
    said: dict[str, list[str]] = {}
    for name, check in CHECKS.items():
        if chosen and name not in chosen:
            continue
        written: list[str] = []
        try:
            with console(written):
                found = check(path)
        except Exception as error:  # A file that cannot be opened is a finding like any other.
            found = [f"{type(error).__name__}: {error}"]
        said[name] = found + [f"console: {line}" for line in written]
    return said


def main() -> None:
    knows_preview_surface()
    paths = sys.stdin.read().splitlines()
    json.dump([findings(path, sys.argv[1:]) for path in paths], sys.stdout)


if __name__ == "__main__":
    main()
