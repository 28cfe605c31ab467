"""Run in an environment with robomimic: one epoch of its own BC-Transformer on an exported file, by its own training script.

Arguments: the HDF5 file; a folder for what training leaves behind.
"""

# pyright: reportMissingImports=false
import json
import sys
from pathlib import Path
from typing import Any

from vision import import_torchvision

import_torchvision()

import h5py  # noqa: E402
import torch  # noqa: E402
from robomimic.config import config_factory  # noqa: E402
from robomimic.scripts.train import train  # noqa: E402
from robomimic.utils.file_utils import get_env_metadata_from_dataset  # noqa: E402

LOW = ["robot0_eef_pos", "robot0_eef_quat", "robot0_gripper_qpos"]
CONTEXT = 8


def main() -> None:
    """Train, and see that its log holds a loss of training and one of validation."""
    file, out = sys.argv[1], Path(sys.argv[2])
    assert get_env_metadata_from_dataset(file)["env_name"].startswith("optimus/")
    torch.set_num_threads(1)
    config = config_for(file, out)
    train(config, device=torch.device("cpu"))
    logs = [path.read_text() for path in out.rglob("log.txt")]
    assert logs and all(f"{kind} Epoch 1" in logs[0] for kind in ("Train", "Validation")), "no epoch of training and validation"
    losses = [json.loads(part[: part.index("}") + 1])["Loss"] for part in logs[0].split(" Epoch 1\n")[1:3]]
    sys.stdout.write(f"robomimic trained one epoch; loss in training and on the valid mask: {losses}\n")


def config_for(file: str, out: Path):
    """robomimic's BC-Transformer with a mixture head, images of every camera in the file, and both masks."""
    with h5py.File(file, "r") as opened:
        seen: Any = opened["data/demo_0/obs"]
        rgb = [name for name in seen if name.endswith("_image")]
    config = config_factory("bc")
    with config.unlocked():
        config.experiment.name, config.experiment.validate = "interop", True
        config.experiment.logging.terminal_output_to_txt, config.experiment.logging.log_tb = True, False
        config.experiment.save.enabled = config.experiment.rollout.enabled = False
        config.experiment.epoch_every_n_steps = config.experiment.validation_epoch_every_n_steps = None
        config.train.data, config.train.output_dir = file, str(out)
        config.train.hdf5_filter_key, config.train.hdf5_validation_filter_key = "train", "valid"
        config.train.num_epochs, config.train.batch_size, config.train.num_data_workers = 1, 16, 0
        config.train.frame_stack, config.train.seq_length = CONTEXT, 1
        config.train.hdf5_cache_mode, config.train.hdf5_load_next_obs = "low_dim", True
        config.algo.transformer.enabled, config.algo.transformer.context_length = True, CONTEXT
        config.algo.transformer.embed_dim, config.algo.transformer.num_layers, config.algo.transformer.num_heads = 64, 2, 4
        config.algo.gmm.enabled = True
        config.observation.modalities.obs.low_dim, config.observation.modalities.obs.rgb = LOW, rgb
        config.observation.encoder.rgb.obs_randomizer_class = "CropRandomizer"
        crop = {"crop_height": 76, "crop_width": 76, "num_crops": 1, "pos_enc": False}
        config.observation.encoder.rgb.obs_randomizer_kwargs = crop
        config.observation.encoder.rgb.core_kwargs.backbone_class = "ResNet18Conv"
        config.observation.encoder.rgb.core_kwargs.backbone_kwargs = {"pretrained": False, "input_coord_conv": False}
        config.observation.encoder.rgb.core_kwargs.pool_class = "SpatialSoftmax"
        config.observation.encoder.rgb.core_kwargs.pool_kwargs = {"num_kp": 32}
    config.lock()
    return config


if __name__ == "__main__":
    main()
