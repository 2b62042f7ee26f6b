#include "viewer/archive/KeyRing.h"

#include <qt6keychain/keychain.h>

#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include "viewer/archive/ServerEntry.h"

namespace fenestra::viewer {
namespace {

QString keyRingService() { return QStringLiteral("Fenestra"); }

QString keyRingProblem(const QKeychain::Job& job) {
  switch (job.error()) {
    case QKeychain::NoError:
    case QKeychain::EntryNotFound:
      return {};
    case QKeychain::NoBackendAvailable:
    case QKeychain::NotImplemented:
      return ServerEntry::tr("This desktop has no key ring that runs, so the password or token is not kept.");
    case QKeychain::AccessDenied:
    case QKeychain::AccessDeniedByUser:
      return ServerEntry::tr("The key ring was not opened, so the password or token is neither read nor kept.");
    default:
      break;
  }
  return ServerEntry::tr("The key ring cannot be used: %1").arg(job.errorString().simplified());
}

/// Jobs delete themselves when they have ended, which may be after whoever started them.
template <class Job>
Job* keyRingJob(const ServerEntry& entry) {
  auto* job = new Job(keyRingService());
  job->setInsecureFallback(false);  // no file in clear in its place
  job->setKey(keyRingName(entry));
  return job;
}

template <class Job>
void startKeyRingJob(Job* job, QObject* context, KeyRingFailure failed) {
  QObject::connect(job, &QKeychain::Job::finished, context, [failed = std::move(failed)](QKeychain::Job* ended) {
    if (const QString problem = keyRingProblem(*ended); !problem.isEmpty()) failed(problem);
  });
  job->start();
}

}  // namespace

QString keyRingName(const ServerEntry& entry) {
  return entry.login == ServerEntry::Login::Password ? QStringLiteral("%1 %2").arg(entry.url, entry.user)
                                                     : QStringLiteral("%1 (token)").arg(entry.url);
}

KeyRingAnswer readKeyRing(const ServerEntry& entry, QWidget* parent) {
  KeyRingAnswer answer;
  auto* job = keyRingJob<QKeychain::ReadPasswordJob>(entry);
  QEventLoop loop;
  QObject::connect(job, &QKeychain::Job::finished, &loop, [&](QKeychain::Job*) {
    answer.problem = keyRingProblem(*job);
    if (job->error() == QKeychain::NoError) answer.secret = job->textData();
    loop.quit();
  });
  job->start();
  // An open ring answers at once. Until then nothing that the user does may change the servers.
  constexpr int soon = 500;  // ms
  bool hasEnded = false;
  QObject::connect(job, &QKeychain::Job::finished, &loop, [&] { hasEnded = true; });
  QTimer::singleShot(soon, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  if (hasEnded) return answer;
  QProgressDialog waiting(ServerEntry::tr("Waiting for the key ring of the desktop…"), ServerEntry::tr("Go on without"),
                          0, 0, parent);
  waiting.setWindowModality(Qt::ApplicationModal);
  waiting.setMinimumDuration(0);
  QObject::connect(&waiting, &QProgressDialog::canceled, &loop, &QEventLoop::quit);
  waiting.show();
  loop.exec();
  if (!hasEnded) answer.problem = ServerEntry::tr("The key ring was not waited for.");
  return answer;
}

void writeKeyRing(const ServerEntry& entry, const QString& secret, QObject* context, KeyRingFailure failed) {
  auto* job = keyRingJob<QKeychain::WritePasswordJob>(entry);
  job->setTextData(secret);
  startKeyRingJob(job, context, std::move(failed));
}

void removeFromKeyRing(const ServerEntry& entry, QObject* context, KeyRingFailure failed) {
  startKeyRingJob(keyRingJob<QKeychain::DeletePasswordJob>(entry), context, std::move(failed));
}

}  // namespace fenestra::viewer
