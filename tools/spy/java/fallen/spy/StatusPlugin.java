// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.service_status_t;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** For lcm-spy: how a service does, in large letters. */
public class StatusPlugin implements SpyPlugin {
  private static final int REFRESH_MS = 500;

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == service_status_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return ChannelWindow.action("Service status", channel, REFRESH_MS, StatusPanel::new,
        (panel, message) -> panel.show((service_status_t) message));
  }
}
